;;; val3-mode.el --- VAL 3, the language of Stäubli robots -*- lexical-binding: t -*-

;;; Commentary:
;; Modes for programs (.pgx), data (.dtx) and projects (.pjx), with the server `val3 lsp' through eglot or lsp-mode.

;;; Code:
(require 'cl-lib)
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

(defun val3--request-handlers ()
  "What lsp-mode does for the server."
  (let ((handlers (make-hash-table :test #'equal)))
    (puthash "workspace/textDocumentContent/refresh"
             (lambda (_ parameters) (val3--code-is-stale (val3--value parameters "uri")) nil)
             handlers)
    handlers))

(defvar lsp-language-id-configuration)
(declare-function lsp-register-client "lsp-mode")
(declare-function make-lsp-client "lsp-mode")
(declare-function lsp-stdio-connection "lsp-mode")
(declare-function lsp-activate-on "lsp-mode")
(with-eval-after-load 'lsp-mode
  (dolist (language '((val3-mode . "val3") (val3-data-mode . "val3-data") (val3-project-mode . "val3-project")))
    (add-to-list 'lsp-language-id-configuration language))
  (lsp-register-client
   (make-lsp-client :request-handlers (val3--request-handlers)
                    :new-connection (lsp-stdio-connection #'val3--contact)
                    :activation-fn (lsp-activate-on "val3" "val3-data" "val3-project")
                    :server-id 'val3)))

;; Requests

(declare-function eglot-current-server "eglot")
(declare-function eglot-managed-p "eglot")
(declare-function jsonrpc-request "jsonrpc")
(declare-function jsonrpc-async-request "jsonrpc")
(declare-function lsp-request "lsp-mode")
(declare-function lsp-request-async "lsp-mode")

(defun val3--uri (scheme)
  "The address of the present file with SCHEME."
  (concat scheme "://" (url-hexify-string (file-truename buffer-file-name) url-path-allowed-chars)))

(defun val3--request (method parameters)
  "The server's answer to METHOD with PARAMETERS, from either client."
  (cond
   ((and (fboundp 'eglot-managed-p) (eglot-managed-p))
    (jsonrpc-request (eglot-current-server) (intern (concat ":" method)) parameters))
   ((bound-and-true-p lsp-mode) (lsp-request method parameters))
   (t (user-error "No server looks after this buffer"))))

(defun val3--request-later (method parameters then)
  "Ask as `val3--request' does, and call THEN with the answer when it comes."
  (cond
   ((and (fboundp 'eglot-managed-p) (eglot-managed-p))
    (jsonrpc-async-request (eglot-current-server) (intern (concat ":" method)) parameters :success-fn then))
   ((bound-and-true-p lsp-mode) (lsp-request-async method parameters then :mode 'detached))))

(defun val3--value (object key)
  "The value of KEY in OBJECT: eglot reads it as a list of properties, lsp-mode perhaps as a table."
  (if (hash-table-p object) (gethash key object) (plist-get object (intern (concat ":" key)))))

;; Code without XML

(defvar-local val3--program nil
  "The buffer of the file of the code.")

(define-derived-mode val3-code-mode prog-mode "VAL 3 code"
  "The code of a program without XML, for reading."
  (setq-local comment-start "// " comment-end "" comment-start-skip "//\\s-*")
  (setq-local font-lock-defaults '(val3-font-lock-keywords))
  (setq-local revert-buffer-function (lambda (&rest _) (val3--read-code)))
  (setq buffer-read-only t))

(defun val3--show-code (buffer answer)
  "Show the text of ANSWER in BUFFER, with the cursor in the same line."
  (with-current-buffer buffer
    (let ((line (line-number-at-pos)) (inhibit-read-only t))
      (erase-buffer)
      (insert (string-replace "\r\n" "\n" (val3--value answer "text")))
      (set-buffer-modified-p nil)
      (goto-char (point-min))
      (forward-line (1- line)))))

(defun val3--read-code ()
  "Take the text of this buffer from the server."
  (val3--show-code
   (current-buffer)
   (with-current-buffer val3--program
     (val3--request "workspace/textDocumentContent" (list :uri (val3--uri "val-text"))))))

(defun val3--code-is-stale (address)
  "Read the code with this ADDRESS again, once the server has its answer."
  (dolist (buffer (buffer-list))
    (with-current-buffer buffer
      (when (and (derived-mode-p 'val3-code-mode)
                 (buffer-live-p val3--program)
                 (equal address (with-current-buffer val3--program (val3--uri "val-text"))))
        (with-current-buffer val3--program
          (val3--request-later "workspace/textDocumentContent" (list :uri address)
                               (lambda (answer) (when (buffer-live-p buffer) (val3--show-code buffer answer)))))))))

(defun val3--lines-before-code ()
  "The number of lines of the present file before its code, whose lines are those of the file, one by one."
  (save-excursion
    (goto-char (point-min))
    (if (re-search-forward "<[Cc]ode[ >]" nil t) (1- (line-number-at-pos)) 0)))

(defun val3-code ()
  "Show the code of the present program without XML."
  (interactive)
  (let ((program (current-buffer))
        (line (max 1 (- (line-number-at-pos) (val3--lines-before-code)))))
    (switch-to-buffer (get-buffer-create (concat (file-name-nondirectory buffer-file-name) " (code)")))
    (val3-code-mode)
    (setq val3--program program)
    (val3--read-code)
    (goto-char (point-min))
    (forward-line (1- line))))

(defun val3-file ()
  "Show the file of the present code."
  (interactive)
  (let ((line (line-number-at-pos)))
    (switch-to-buffer val3--program)
    (goto-char (point-min))
    (forward-line (+ (val3--lines-before-code) (1- line)))))

(define-key val3-code-mode-map (kbd "C-c C-f") #'val3-file)
(define-key val3-mode-map (kbd "C-c C-v") #'val3-code)

(with-eval-after-load 'eglot
  (cl-defmethod eglot-handle-request (_server (_method (eql workspace/textDocumentContent/refresh)) &key uri)
    "The server says that the text at URI has changed."
    (val3--code-is-stale uri)
    nil))

;; Tests

(define-compilation-mode val3-test-mode "VAL 3 tests"
  "Results of tests, with links to their lines."
  (setq-local compilation-error-regexp-alist '(("^ *at .* (\\(.+\\):\\([0-9]+\\))$" 1 2))))

(defun val3--tests ()
  "The tests of the present file, as the server lists them."
  (val3--request "workspace/executeCommand" (list :command "val3.tests" :arguments (vector (val3--uri "file")))))

(defun val3-test ()
  "Execute the test of the present file, and show its result."
  (interactive)
  (save-some-buffers)
  (let ((tests (append (val3--tests) nil)))
    (unless tests (user-error "This file has no test"))
    (compilation-start (mapconcat #'shell-quote-argument (append (val3--value (car tests) "command") nil) " ") #'val3-test-mode)))

(provide 'val3-mode)
;;; val3-mode.el ends here
