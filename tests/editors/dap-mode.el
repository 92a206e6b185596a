;;; dap-mode.el --- Emacs with dap-mode and the files of editors/emacs -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
(setq lsp-session-file (make-temp-name (expand-file-name "val3-lsp-session-" temporary-file-directory))
      dap-breakpoints-file (make-temp-name (expand-file-name "val3-dap-breakpoints-" temporary-file-directory))
      lsp-auto-guess-root t
      dap-auto-configure-features nil
      dap-auto-show-output nil
      dap-print-io nil)
(load (expand-file-name "emacs-steps.el" (file-name-directory load-file-name)) nil t)
(load (concat root "/editors/emacs/val3-dap.el") nil t)
(setq val3-dap-command (list (getenv "VAL3_SERVER") "dap"))

(defvar ended nil)
(add-hook 'dap-terminated-hook (lambda (_) (setq ended t)))

(defun session ()
  "The present session."
  (dap--cur-session))

(defun shown ()
  "The file and the line that the window shows, once they are those of the active frame."
  (when-let ((session (session)) (frame (dap--debug-session-active-frame session)))
    (with-current-buffer (window-buffer)
      (when (eql (line-number-at-pos (window-point)) (gethash "line" frame))
        (list (file-name-nondirectory buffer-file-name) (gethash "line" frame))))))

(defun until-shown (file line)
  "Wait until the window shows LINE of FILE, and the run is stopped there."
  (until (format "%s:%d" file line) (lambda () (equal (shown) (list file line)))))

(defun ask (command arguments)
  "The body of the answer to COMMAND with ARGUMENTS."
  (let (answer)
    (dap--send-message (dap--make-request command arguments) (lambda (response) (setq answer response)) (session))
    (until command (lambda () answer))
    (cl-assert (gethash "success" answer) t "%s" command)
    (gethash "body" answer)))

(defun frame-id ()
  "The number of the active frame."
  (gethash "id" (dap--debug-session-active-frame (session))))

(defun locals ()
  "Names and values of the locals of the active frame."
  (let* ((scopes (append (gethash "scopes" (ask "scopes" (list :frameId (frame-id)))) nil))
         (scope (cl-find "Locals" scopes :key (lambda (scope) (gethash "name" scope)) :test #'equal))
         (variables (ask "variables" (list :variablesReference (gethash "variablesReference" scope)))))
    (mapcar (lambda (variable) (cons (gethash "name" variable) (gethash "value" variable)))
            (gethash "variables" variables))))

(defun run ()
  "All steps, on a copy of the example cell."
  (let* ((folder (file-truename (make-temp-file "val3-dap-mode-" t)))
         (application (concat folder "/cell/usr/usrapp/palletiser/")))
    (copy-directory (concat root "/examples/palletiser/usr") (concat folder "/cell/usr") nil t)
    (lsp-workspace-folders-add (concat folder "/cell"))
    (switch-to-buffer (find-file-noselect (concat application "tower.pgx")))
    (step "a breakpoint is set in a program"
      (place "while l_sKey")
      (dap-breakpoint-add))
    (step "the application of the buffer starts and stops before its first line"
      (dap-debug (cdr (assoc "VAL 3, from the first line" dap-debug-template-configurations)))
      (until-shown "start.pgx" 5))
    (step "a step goes into a program, and another one over a line"
      (dap-step-in (session))
      (until-shown "init.pgx" 5)
      (dap-next (session))
      (until-shown "init.pgx" 6))
    (step "the run continues to the breakpoint"
      (dap-continue (session) (dap--debug-session-thread-id (session)))
      (until-shown "tower.pgx" 13))
    (step "locals are seen"
      (cl-assert (equal (locals) '(("l_sKey" . "\"amber\"")))))
    (step "expressions are evaluated"
      (let ((body (ask "evaluate" (list :expression "len(l_sKey)+nLayer" :frameId (frame-id)))))
        (cl-assert (equal (gethash "result" body) "5"))))
    (step "the session ends"
      (dap-disconnect (session))
      (until "end" (lambda () ended)))
    (delete-directory folder t)))

(run-test "dap-mode" #'run)
