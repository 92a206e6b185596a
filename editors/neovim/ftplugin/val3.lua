vim.bo.commentstring = '// %s'
vim.bo.shiftwidth = 2
vim.bo.expandtab = true
-- Files of the controller have no line end at their end, and keep it so.
vim.bo.fixendofline = false
