// Builds the page into the Python package. No hash in a file name: the bundle is committed and a
// test compares it byte for byte with a new build.
import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: {
    outDir: '../rvd_groundstation/console/static',
    emptyOutDir: true,
    assetsInlineLimit: 0,
    target: 'es2022',
    modulePreload: { polyfill: false },
    rollupOptions: {
      output: {
        entryFileNames: 'assets/[name].js',
        chunkFileNames: 'assets/[name].js',
        assetFileNames: 'assets/[name][extname]',
      },
    },
  },
  worker: {
    format: 'es',
    rollupOptions: { output: { entryFileNames: 'assets/[name].js' } },
  },
});
