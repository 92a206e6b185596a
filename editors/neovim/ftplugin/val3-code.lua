vim.bo.commentstring = '// %s'
vim.api.nvim_buf_create_user_command(0, 'Val3File', require('val3_code').open_file, { desc = 'Show the file of this code' })
require('val3_code_requests').map(0)
