-- The language server of VAL 3, for `vim.lsp.enable('val3')` (Neovim 0.11 and later).
return {
  cmd = { 'val3', 'lsp' },
  filetypes = { 'val3', 'val3-data', 'val3-project' },
  -- The controller's folder where there is one, else the nearest configuration or repository.
  root_markers = { 'usr', 'val3.toml', '.git' },
}
