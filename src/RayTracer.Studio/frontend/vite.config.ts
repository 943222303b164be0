import { defineConfig } from "vitest/config";

// Names without hashes: the built files are committed, and a change of one source shall change as few of them as possible.
const names = {
  entryFileNames: "assets/[name].js",
  chunkFileNames: "assets/[name].js",
  assetFileNames: "assets/[name][extname]",
};

export default defineConfig({
  base: "./",
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  build: {
    outDir: "../wwwroot",
    emptyOutDir: true,
    target: "es2022",
    cssTarget: ["chrome123", "firefox120", "safari17.5"],
    modulePreload: { polyfill: false },
    // Nothing is inlined into the page: its content security policy allows files only.
    assetsInlineLimit: 0,
    rollupOptions: { output: names },
    chunkSizeWarningLimit: 600,
  },
  // The texts and commands that all faces of the session share.
  server: { fs: { allow: [".", "../../RayTracer.Session/Texts"] } },
  worker: { format: "es", rollupOptions: { output: names } },
  // Where a build has the processor meanwhile, a module alone can take ten seconds to load.
  test: { include: ["tests/**/*.test.ts"], environment: "node", testTimeout: 60_000, hookTimeout: 60_000 },
});
