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
    "#]],
    );
}

#[test]
fn comments_are_named_as_such() {
    check(
        OLD,
        &OLD.replace("// look", "// look twice"),
        &expect![[r#"
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
    "#]],
    );
}

#[test]
fn new_syntax_errors_are_named() {
    check(
        OLD,
        &OLD.replace("l_i=x_n", "l_i==="),
        &expect![[r#"
    "#]],
    );
}
