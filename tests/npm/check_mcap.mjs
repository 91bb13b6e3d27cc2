// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// node check_mcap.mjs FILE: reads FILE twice with the MCAP project's own library, as a stream and through the index,
// checks every CRC and that both ways agree, and prints what the file holds as JSON. Exits with 1 on anything wrong.
import { crc32 } from "@foxglove/crc";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { decompress as decompressZstd } from "fzstd";
import lz4 from "lz4js";
import { createHash } from "node:crypto";
import { open, readFile } from "node:fs/promises";

const decompressHandlers = {
  zstd: (packed, size) => decompressZstd(packed, new Uint8Array(Number(size))),
  lz4: (packed, size) => Uint8Array.from(lz4.decompress(packed, Number(size))),
};

function check(condition, what) {
  if (!condition) {
    throw new Error(what);
  }
}

const digest = (message) =>
  createHash("sha256")
    .update(`${message.channelId} ${message.sequence} ${message.logTime} ${message.publishTime} `)
    .update(message.data)
    .digest("hex");

function readStream(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true, includeChunks: true });
  const records = {};
  reader.append(bytes);
  for (let record = reader.nextRecord(); record; record = reader.nextRecord()) {
    (records[record.type] ??= []).push(record);
  }
  check(reader.done(), "the stream has no end");
  return records;
}

function checkCrcs(records, bytes) {
  for (const chunk of records.Chunk ?? []) {
    check(chunk.uncompressedCrc !== 0, "a chunk without a CRC");
  }
  const [footer] = records.Footer;
  check(footer.summaryCrc !== 0, "no summary CRC");
  // Nothing but the data end lies between data section and summary.
  const dataEnd = Number(footer.summaryStart) - 13;
  check(records.DataEnd[0].dataSectionCrc === crc32(bytes.subarray(0, dataEnd)), "the data section's CRC is wrong");
}

function checkSummary(reader, records) {
  const statistics = reader.statistics;
  const count = (type) => (records[type] ?? []).length;
  check(statistics, "no statistics");
  check(Number(statistics.messageCount) === count("Message"), "the statistics count other messages");
  check(statistics.chunkCount === count("Chunk"), "the statistics count other chunks");
  check(reader.chunkIndexes.length === count("Chunk"), "not every chunk is in the index");
  check(statistics.schemaCount === reader.schemasById.size, "the statistics count other schemas");
  check(statistics.channelCount === reader.channelsById.size, "the statistics count other channels");
  check(statistics.attachmentCount === reader.attachmentIndexes.length, "not every attachment is in the index");
  check(statistics.metadataCount === reader.metadataIndexes.length, "not every metadata record is in the index");
  check(count("Attachment") === reader.attachmentIndexes.length, "the index has other attachments");
  check(count("Metadata") === reader.metadataIndexes.length, "the index has other metadata");
  check(count("SummaryOffset") > 0, "no summary offsets");
}

function checkMessageIndexes(records) {
  const entries = (records.MessageIndex ?? []).reduce((sum, index) => sum + index.records.length, 0);
  check(entries === (records.Message ?? []).length, "the message indexes do not list every message");
}

async function checkIndexedMessages(reader, records) {
  const seen = [];
  let last = 0n;
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    check(message.logTime >= last, `log time runs back at ${message.logTime}`);
    last = message.logTime;
    seen.push(digest(message));
  }
  const streamed = (records.Message ?? []).map(digest);
  check(seen.sort().join() === streamed.sort().join(), "index and stream give different messages");
}

async function checkExtras(reader) {
  for await (const attachment of reader.readAttachments({ validateCrcs: true })) {
    check(attachment.name !== undefined, "an attachment without a name");
  }
  for await (const metadata of reader.readMetadata()) {
    check(metadata.name !== undefined, "metadata without a name");
  }
}

async function checkFile(path) {
  const bytes = await readFile(path);
  const records = readStream(bytes);
  checkCrcs(records, bytes);
  checkMessageIndexes(records);
  const file = await open(path);
  const readable = {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const buffer = new Uint8Array(Number(size));
      const { bytesRead } = await file.read(buffer, 0, buffer.length, Number(offset));
      return buffer.subarray(0, bytesRead);
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  checkSummary(reader, records);
  await checkIndexedMessages(reader, records);
  await checkExtras(reader);
  await file.close();
  return {
    profile: reader.header.profile,
    library: reader.header.library,
    messages: (records.Message ?? []).length,
    chunks: reader.chunkIndexes.length,
    compressions: [...new Set(reader.chunkIndexes.map((chunk) => chunk.compression))],
    topics: [...reader.channelsById.values()].map((channel) => channel.topic).sort(),
    schemas: [...reader.schemasById.values()].map((schema) => schema.name).sort(),
    attachments: reader.attachmentIndexes.length,
    metadata: reader.metadataIndexes.map((entry) => entry.name),
  };
}

try {
  console.log(JSON.stringify(await checkFile(process.argv[2])));
} catch (error) {
  console.error(`${process.argv[2]}: ${error.message}`);
  process.exit(1);
}
