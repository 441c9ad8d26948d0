// A worker of the page that unpacks the snapshot. No browser unpacks zstd by itself, but what gzip makes of a memory is a
// third larger: gzip looks back 32 kB.

import { decompress } from "fzstd"

addEventListener("message", ({ data }) => {
  const { buffer } = decompress(new Uint8Array(data)).slice() // what that gives does not begin where its buffer does
  postMessage(buffer, { transfer: [buffer] })
})
