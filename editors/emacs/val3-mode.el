;;; val3-mode.el --- VAL 3, the language of Stäubli robots -*- lexical-binding: t -*-

;;; Commentary:
;; Modes for programs (.pgx), data (.dtx) and projects (.pjx), with the server `val3 lsp' through eglot or lsp-mode.

;;; Code:
(require 'compile)
(require 'nxml-mode)
(require 'url-util)

(defgroup val3 nil
  "VAL 3, the language of Stäubli robots."
  :group 'languages)

(defcustom val3-server-command '("val3" "lsp")
  "The language server and its arguments."
  :type '(repeat string))

(defconst val3-keywords
  '("begin" "end" "call" "return" "if" "elseIf" "else" "endIf" "while" "endWhile" "do" "until" "for" "to" "step"
    "endFor" "switch" "case" "break" "default" "endSwitch" "and" "or" "xor" "taskCreate" "taskCreateSync")
  "The keywords of code.")

(defconst val3-font-lock-keywords
  `(("^\\s-*//.*$" 0 font-lock-comment-face t)
    (,(regexp-opt val3-keywords 'words) 0 font-lock-keyword-face)
    ("\\_<\\(?:true\\|false\\)\\_>" 0 font-lock-constant-face)
    ("\\_<call\\s-+\\([A-Za-z_:0-9]+\\)" 1 font-lock-function-name-face))
  "Colours of code, within the XML.")

(defun val3--keep-the-end ()
  "Files of the controller have no line end at their end, and keep it so."
  (setq-local require-final-newline nil)
  (setq-local mode-require-final-newline nil))

;;;###autoload
(define-derived-mode val3-mode nxml-mode "VAL 3"
  "Programs: XML with code inside."
  (val3--keep-the-end)
  (setq-local comment-start "// " comment-end "" comment-start-skip "//\\s-*")
  (setq-local indent-line-function #'indent-relative-first-indent-point)
  (setq-local tab-width 2 indent-tabs-mode nil)
  (font-lock-add-keywords nil val3-font-lock-keywords))

;;;###autoload
(define-derived-mode val3-data-mode nxml-mode "VAL 3 data" "Data: XML." (val3--keep-the-end))

;;;###autoload
(define-derived-mode val3-project-mode nxml-mode "VAL 3 project" "Projects: XML." (val3--keep-the-end))

;;;###autoload
(progn
  (add-to-list 'auto-mode-alist '("\\.[pP][gG][xX]\\'" . val3-mode))
  (add-to-list 'auto-mode-alist '("\\.[dD][tT][xX]\\'" . val3-data-mode))
  (add-to-list 'auto-mode-alist '("\\.[pP][jJ][xX]\\'" . val3-project-mode)))

(defun val3--contact (&rest _)
  "The command of the server."
  val3-server-command)

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  ;; One server for the three modes. Their languages are named `val3', `val3-data' and `val3-project'.
  (put 'val3-mode 'eglot-language-id "val3")
  (put 'val3-data-mode 'eglot-language-id "val3-data")
  (put 'val3-project-mode 'eglot-language-id "val3-project")
  (add-to-list 'eglot-server-programs '((val3-mode val3-data-mode val3-project-mode) . val3--contact)))

(defvar lsp-language-id-configuration)
(declare-function lsp-register-client "lsp-mode")
(declare-function make-lsp-client "lsp-mode")
(declare-function lsp-stdio-connection "lsp-mode")
(declare-function lsp-activate-on "lsp-mode")
(with-eval-after-load 'lsp-mode
  (dolist (language '((val3-mode . "val3") (val3-data-mode . "val3-data") (val3-project-mode . "val3-project")))
    (add-to-list 'lsp-language-id-configuration language))
  (lsp-register-client
   (make-lsp-client :new-connection (lsp-stdio-connection #'val3--contact)
                    :activation-fn (lsp-activate-on "val3" "val3-data" "val3-project")
                    :server-id 'val3)))

;; Tests

(declare-function eglot-current-server "eglot")
(declare-function eglot-managed-p "eglot")
(declare-function jsonrpc-request "jsonrpc")
(declare-function lsp-request "lsp-mode")

(define-compilation-mode val3-test-mode "VAL 3 tests"
  "Results of tests, with links to their lines."
  (setq-local compilation-error-regexp-alist '(("^ *at .* (\\(.+\\):\\([0-9]+\\))$" 1 2))))

(defun val3--tests ()
  "The tests of the present file, as the server lists them."
  (let* ((uri (concat "file://" (url-hexify-string (file-truename buffer-file-name) url-path-allowed-chars)))
         (request (list :command "val3.tests" :arguments (vector uri))))
    (cond
     ((and (fboundp 'eglot-managed-p) (eglot-managed-p))
      (jsonrpc-request (eglot-current-server) :workspace/executeCommand request))
     ((bound-and-true-p lsp-mode) (lsp-request "workspace/executeCommand" request))
     (t (user-error "No server looks after this buffer")))))

(defun val3--command (test)
  "The command that executes TEST: eglot reads it as a list of properties, lsp-mode perhaps as a table."
  (append (if (hash-table-p test) (gethash "command" test) (plist-get test :command)) nil))

(defun val3-test ()
  "Execute the test of the present file, and show its result."
  (interactive)
  (save-some-buffers)
  (let ((tests (append (val3--tests) nil)))
    (unless tests (user-error "This file has no test"))
    (compilation-start (mapconcat #'shell-quote-argument (val3--command (car tests)) " ") #'val3-test-mode)))

(provide 'val3-mode)
;;; val3-mode.el ends here
