//! Programs: code, layout, comments, parameters, locals.

use expect_test::expect;

use crate::support::check;

const OLD: &str = "
public program pick(num x_n)
  num l_i
begin
  l_i=x_n
  // look
  if l_i>1
    put(l_i)
  endIf
end
";

#[test]
fn lines_are_those_of_the_code() {
    let new = OLD.replace("l_i>1", "l_i>2").replace("put(l_i)", "put(l_i)\n    put(\"x\")");
    check(
        OLD,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Programs
                ~ pick(num x_n)  +2 −1 lines
                  1   begin
                  2     l_i=x_n
                  3     // look
                  4 -   if l_i>1
                  4 +   if l_i>2
                  5       put(l_i)
                  6 +     put("x")
                  7     endIf
                  8   end

            1 application differs: 1 program
        "#]],
    );
}

#[test]
fn layout_is_no_change_of_the_code() {
    let new = OLD.replace("l_i>1", "l_i > 1").replace("  // look\n", "\n      // look\n").replace("endIf", "ENDIF");
    check(
        OLD,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Programs
                ~ pick  only the layout of the code differs

            1 application differs: 1 program
        "#]],
    );
}

#[test]
fn comments_are_named_as_such() {
    check(
        OLD,
        &OLD.replace("// look", "// look twice"),
        &expect![[r#"
            main  main/main.pjx
              Programs
                ~ pick(num x_n)  only comments differ
                  1   begin
                  2     l_i=x_n
                  3 -   // look
                  3 +   // look twice
                  4     if l_i>1
                  5       put(l_i)
                  6     endIf

            1 application differs: 1 program
        "#]],
    );
}

#[test]
fn parameters_and_locals_are_part_of_a_program() {
    let new = OLD.replace("(num x_n)", "(num& x_n, string x_s)").replace("  num l_i\n", "  num l_i[3]\n  bool l_b\n");
    check(
        OLD,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Interface  no project file here names it
                ~ program pick  was pick(num), is now pick(num&, string)
              Programs
                ~ pick(num& x_n, string x_s)  same code
                    was pick(num x_n)
                    new local bool l_b
                    local num l_i → num l_i[3]

            1 application differs: 1 program, 1 public item
        "#]],
    );
}

#[test]
fn programs_are_added_removed_and_hidden() {
    let new = "
        program pick(num x_n)
          num l_i
        begin
          l_i=x_n
          // look
          if l_i>1
            put(l_i)
          endIf
        end
        program place()
        begin
          put(1)
        end
        ";
    let old = format!("{OLD}\nprogram gone()\nbegin\nend\n");
    check(
        &old,
        new,
        &expect![[r#"
            main  main/main.pjx
              Interface  no project file here names it
                - program pick  pick(num)
              Programs
                - gone()  2 lines
                ~ pick(num x_n)  same code
                    access public → private
                + place()  3 lines

            1 application differs: 3 programs, 1 public item
        "#]],
    );
}

#[test]
fn new_syntax_errors_are_named() {
    check(
        OLD,
        &OLD.replace("l_i=x_n", "l_i==="),
        &expect![[r#"
            main  main/main.pjx
              Programs
                ~ pick(num x_n)  +1 −1 lines
                ! the new code has syntax errors; `val3 check` shows them
                  1   begin
                  2 -   l_i=x_n
                  2 +   l_i===
                  3     // look
                  4     if l_i>1
                  5       put(l_i)

            1 application differs: 1 program
        "#]],
    );
}
