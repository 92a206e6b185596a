;;; emacs-steps.el --- What the tests of Emacs share -*- lexical-binding: t -*-
(require 'cl-lib)

(defvar root (getenv "VAL3_ROOT"))
(defvar passed 0)
(load (concat root "/editors/emacs/val3-mode.el") nil t)
(setq val3-server-command (list (concat root "/tests/editors/record") "lsp")
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

(defun check-files (application old new files)
  "Each of FILES in APPLICATION is that of the example, with NEW for OLD."
  (dolist (file files)
    (let ((before (bytes (concat root "/examples/palletiser/usr/usrapp/palletiser/" file))))
      (cl-assert (equal (bytes (concat application file)) (replace-regexp-in-string old new before t t)) t "%s" file))))

(defun copy-cell (cell)
  "Copy the example to CELL, with a first test beside a library."
  (copy-directory (concat root "/examples/palletiser/usr") (concat cell "/usr") nil t)
  (call-process (getenv "VAL3_SERVER") nil nil nil "test" "--init" (concat cell "/usr/usrapp/partBox")))

(defun present-line ()
  "The text of the line of the cursor."
  (buffer-substring-no-properties (line-beginning-position) (line-end-position)))

(defun check-code (signal)
  "The code of the present program is shown, and follows a change that SIGNAL sends."
  (place "movel(pPick")
  (let ((line (line-number-at-pos)) (text (present-line)) (program (current-buffer)))
    (val3-code)
    (cl-assert (and buffer-read-only (derived-mode-p 'val3-code-mode)))
    (cl-assert (equal (present-line) text))
    (goto-char (point-min))
    (cl-assert (looking-at-p "begin$"))
    (search-forward text)
    (let ((code (current-buffer)))
      (val3-file)
      (cl-assert (eq (current-buffer) program))
      (cl-assert (= (line-number-at-pos) line))
      (beginning-of-line)
      (insert "  // the first line\n")
      (funcall signal)
      (until "new text"
        (lambda () (with-current-buffer code (save-excursion (goto-char (point-min)) (search-forward "the first line" nil t)))))
      (delete-region (line-beginning-position 0) (line-beginning-position))
      (funcall signal)
      (set-buffer-modified-p nil)
      (cl-assert (equal (present-line) text)))))

(defun check-test ()
  "The test of the present file fails, and its line is a link."
  (place "1+1,2")
  (delete-char 3)
  (insert "3")
  (save-buffer)
  (val3-test)
  (with-current-buffer "*val3-test*"
    (until "result" (lambda () (save-excursion (goto-char (point-min)) (search-forward "0 passed, 1 failed" nil t))))
    (goto-char (point-min))
    (compilation-next-error 1)
    (cl-assert (looking-at-p " *at partBoxTest:testFirst"))))

(defun run-test (name run)
  "Call RUN, print how many steps of the test NAME passed, and end."
  (let ((failed 0))
    (condition-case fault (funcall run)
      (error (setq failed 1) (princ (format "FAILED %S\n" fault))))
    (princ (format "test result: %s. %d passed; %d failed; %s\n" (if (= failed 0) "ok" "FAILED") passed failed name))
    (kill-emacs failed)))
