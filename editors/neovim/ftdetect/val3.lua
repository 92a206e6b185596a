vim.filetype.add({
  extension = { pgx = 'val3', PGX = 'val3', dtx = 'val3-data', DTX = 'val3-data', pjx = 'val3-project', PJX = 'val3-project' },
})
-- The XML is coloured by the grammar of XML, the code by the server's semantic tokens.
for _, filetype in ipairs({ 'val3', 'val3-data', 'val3-project' }) do
  vim.treesitter.language.register('xml', filetype)
end
