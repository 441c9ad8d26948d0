// Loaded only where the browser has no SHA-256 of its own.

export { sha256 } from "@noble/hashes/sha2.js"
