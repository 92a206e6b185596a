;;; emacs.el --- Emacs with the file of editors/emacs, as a user's configuration would have it -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
(require 'eglot)
(require 'flymake)
(load (expand-file-name "emacs-steps.el" (file-name-directory load-file-name)) nil t)

(setenv "VAL3_TRACE" (concat (getenv "VAL3_OUTPUT") "/traces/emacs.jsonl"))
(setq eglot-sync-connect 20
      eglot-autoshutdown t
      flymake-no-changes-timeout 0.1)

(defun run ()
  "All steps, on a copy of the example cell."
  (let* ((folder (make-temp-file "val3-emacs-" t))
         (application (concat folder "/cell/usr/usrapp/palletiser/")))
    (copy-cell (concat folder "/cell"))
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
      (check-files application "bHolding" "bCarries" '("pick.pgx" "place.pgx" "sensors.pgx" "init.pgx" "palletiser.dtx")))
    (step "the code is shown without XML and follows the file"
      (check-code #'eglot--signal-textDocument/didChange))
    (eglot-shutdown (eglot-current-server))
    (step "the test of a file is executed"
      (switch-to-buffer (find-file-noselect (concat folder "/cell/usr/usrapp/partBoxTest/testFirst.pgx")))
      (let ((default-directory (concat folder "/cell/"))) (apply #'eglot (eglot--guess-contact)))
      (until "server" #'eglot-managed-p)
      (check-test))
    (eglot-shutdown (eglot-current-server))
    (delete-directory folder t)))

(run-test "emacs" #'run)
