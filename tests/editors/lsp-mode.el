;;; lsp-mode.el --- Emacs with lsp-mode and the file of editors/emacs -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
(require 'lsp-mode)
(load (expand-file-name "emacs-steps.el" (file-name-directory load-file-name)) nil t)

(setenv "VAL3_TRACE" (concat (getenv "VAL3_OUTPUT") "/traces/lsp-mode.jsonl"))
(setq lsp-session-file (make-temp-name (expand-file-name "val3-lsp-session-" temporary-file-directory))
      lsp-enable-file-watchers nil
      lsp-restart 'ignore
      lsp-response-timeout 20)

(defun diagnostics ()
  "The findings of the current file."
  (gethash (lsp--fix-path-casing buffer-file-name) (lsp-diagnostics t)))

(defun run ()
  "All steps, on a copy of the example cell."
  (let* ((folder (file-truename (make-temp-file "val3-lsp-mode-" t)))
         (application (concat folder "/cell/usr/usrapp/palletiser/")))
    (copy-cell (concat folder "/cell"))
    (lsp-workspace-folders-add (concat folder "/cell"))
    (switch-to-buffer (find-file-noselect (concat application "pick.pgx")))
    (step "a program is recognised and the server starts"
      (cl-assert (equal (lsp-buffer-language) "val3"))
      (lsp)
      (until "server" (lambda () (and (lsp-workspaces) (eq 'initialized (lsp--workspace-status (car (lsp-workspaces))))))))
    (step "a mistake is shown and disappears"
      (place "waitEndMove()")
      (forward-char (length "waitEndMove("))
      (insert "1")
      (let ((found (car (until "diagnostic" #'diagnostics))))
        (cl-assert (string-match-p "waitEndMove" (lsp:diagnostic-message found))))
      (delete-char -1)
      (until "repair" (lambda () (not (diagnostics)))))
    (step "hover tells what a point is"
      (place "pPick,tSuction,mSlow")
      (let ((answer (lsp-request "textDocument/hover" (lsp--text-document-position-params))))
        (cl-assert (string-match-p "pPick" (lsp:markup-content-value (lsp:hover-contents answer))))))
    (step "a name is changed in every file"
      (place "bHolding=x_bOk")
      (lsp-rename "bCarries")
      (save-some-buffers t)
      (check-files application "bHolding" "bCarries" '("pick.pgx" "place.pgx" "sensors.pgx" "init.pgx" "palletiser.dtx")))
    (step "the code is shown without XML and follows the file"
      (check-code #'ignore))
    (step "definition leads to the data"
      (place "tSuction,mSlow")
      (lsp-find-definition)
      (cl-assert (string-suffix-p "palletiser.dtx" buffer-file-name)))
    (step "the test of a file is executed"
      (switch-to-buffer (find-file-noselect (concat folder "/cell/usr/usrapp/partBoxTest/testFirst.pgx")))
      (lsp)
      (check-test))
    (with-current-buffer "pick.pgx" (lsp-workspace-shutdown (car (lsp-workspaces))))
    (delete-directory folder t)))

(run-test "lsp-mode" #'run)
