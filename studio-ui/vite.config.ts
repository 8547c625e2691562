import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

// The built files ship in the Python package; the server serves them at "/".
export default defineConfig({
  plugins: [react()],
  base: "./",
  build: {
    outDir: "../src/swifttailor/studio/client",
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
  },
  server: {
    proxy: { "/api": { target: process.env.STUDIO ?? "http://127.0.0.1:8765", changeOrigin: true } },
  },
  test: { environment: "jsdom", include: ["src/**/*.test.{ts,tsx}"] },
});
