;;; emacs.el --- Emacs with the file of editors/emacs, as a user's configuration would have it -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
(require 'cl-lib)
(require 'eglot)
(require 'flymake)

(defvar root (getenv "VAL3_ROOT"))
(defvar passed 0)
(setenv "VAL3_TRACE" (concat (getenv "VAL3_OUTPUT") "/traces/emacs.jsonl"))
(load (concat root "/editors/emacs/val3-mode.el") nil t)
(setq val3-server-command (list (concat root "/tests/editors/record") "lsp")
      eglot-sync-connect 20
      eglot-autoshutdown t
      flymake-no-changes-timeout 0.1
      make-backup-files nil)

(defun until (what condition)
  "Wait until CONDITION gives something, and return it; WHAT is missing otherwise."
  (let ((end (+ (float-time) 10)) found)
    (while (and (not (setq found (funcall condition))) (< (float-time) end))
      (accept-process-output nil 0.05))
    (or found (error "No %s" what))))

(defmacro step (name &rest body)
  "Run BODY, which NAME describes."
  (declare (indent 1))
  `(progn ,@body (cl-incf passed) (princ (format "ok %s\n" ,name))))

(defun place (text)
  "Put the cursor on the beginning of TEXT."
  (goto-char (point-min))
  (search-forward text)
  (goto-char (match-beginning 0)))

(defun bytes (path)
  "The content of the file PATH."
  (with-temp-buffer
    (set-buffer-multibyte nil)
    (insert-file-contents-literally path)
    (buffer-string)))

(defun run ()
  "All steps, on a copy of the example cell."
  (let* ((folder (make-temp-file "val3-emacs-" t))
         (application (concat folder "/cell/usr/usrapp/palletiser/")))
    (copy-directory (concat root "/examples/palletiser") (concat folder "/cell"))
    (switch-to-buffer (find-file-noselect (concat application "pick.pgx")))
    (step "a program is recognised and the server starts"
      (cl-assert (eq major-mode 'val3-mode))
      (let ((default-directory application)) (apply #'eglot (eglot--guess-contact)))
      (until "server" #'eglot-managed-p))
    (step "a mistake is shown and disappears"
      (place "waitEndMove()")
      (forward-char (length "waitEndMove("))
      (insert "1")
      (eglot--signal-textDocument/didChange)
      (let ((found (car (until "diagnostic" (lambda () (flymake-start) (flymake-diagnostics))))))
        (cl-assert (string-match-p "waitEndMove" (flymake-diagnostic-text found)))
        (cl-assert (= 24 (line-number-at-pos (flymake-diagnostic-beg found)))))
      (delete-char -1)
      (eglot--signal-textDocument/didChange)
      (until "repair" (lambda () (flymake-start) (not (flymake-diagnostics)))))
    (step "hover tells what a point is"
      (place "pPick,tSuction,mSlow")
      (let (shown)
        (eglot-hover-eldoc-function (lambda (text &rest _) (setq shown text)))
        (until "hover" (lambda () shown))
        (cl-assert (string-match-p "pPick" shown))))
    (step "definition leads to the data"
      (place "tSuction,mSlow")
      (let* ((backend (xref-find-backend))
             (found (xref-backend-definitions backend (xref-backend-identifier-at-point backend)))
             (location (xref-item-location (car found))))
        (cl-assert (string-suffix-p "palletiser.dtx" (xref-location-group location)))))
    (step "a name is changed in every file"
      (place "bHolding=x_bOk")
      ;; Eglot lists the files and asks.
      (cl-letf (((symbol-function 'y-or-n-p) #'always)) (eglot-rename "bCarries"))
      (save-some-buffers t)
      (dolist (file '("pick.pgx" "place.pgx" "sensors.pgx" "init.pgx" "palletiser.dtx"))
        (let ((before (bytes (concat root "/examples/palletiser/usr/usrapp/palletiser/" file))))
          (cl-assert (equal (bytes (concat application file))
                            (replace-regexp-in-string "bHolding" "bCarries" before t t))
                     t "%s" file))))
    (eglot-shutdown (eglot-current-server))
    (delete-directory folder t)))

(let ((failed 0))
  (condition-case fault (run)
    (error (setq failed 1) (princ (format "FAILED %S\n" fault))))
  (princ (format "test result: %s. %d passed; %d failed; emacs\n" (if (= failed 0) "ok" "FAILED") passed failed))
  (kill-emacs failed))
