;;; val3-dap.el --- Debug VAL 3 programs with dap-mode -*- lexical-binding: t -*-

;;; Commentary:
;; Load it after val3-mode.el. `M-x dap-debug' then offers the configuration `VAL 3', which runs the application of the
;; present buffer up to the first breakpoint.

;;; Code:
(require 'dap-mode)
;; dap-mode asks it for the exception filters.
(require 'dap-ui)

(defcustom val3-dap-command '("val3" "dap")
  "The debug adapter and its arguments."
  :group 'val3
  :type '(repeat string))

(defun val3-dap--application ()
  "The application of the present buffer: the folder of its file."
  (expand-file-name (or (and buffer-file-name (file-name-directory buffer-file-name)) default-directory)))

(defun val3-dap--complete (configuration)
  "CONFIGURATION with the adapter, and with the application of the present buffer if it names none."
  (let* ((application (or (plist-get configuration :program) (val3-dap--application)))
         (completed (plist-put configuration :program application)))
    (plist-put completed :dap-server-path val3-dap-command)))

(dap-register-debug-provider "val3" #'val3-dap--complete)
(dap-register-debug-template "VAL 3" (list :type "val3" :request "launch" :name "VAL 3"))
(dap-register-debug-template
 "VAL 3, from the first line" (list :type "val3" :request "launch" :name "VAL 3, from the first line" :stopOnEntry t))

(provide 'val3-dap)
;;; val3-dap.el ends here
