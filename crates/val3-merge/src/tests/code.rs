//! Programs.

use expect_test::{Expect, expect};

use super::merged;
use crate::{MergedKind, merge};

const NEW: &str = r#"<Programs>
  <Program name="pick" access="public">
    <Parameters>
      <Parameter name="x_n" type="num" xsi:type="element" />
    </Parameters>
    <Locals>
      <Local name="l_i" type="num" xsi:type="array" size="1" />
    </Locals>
    <Code><![CDATA[begin
  l_i=1
  l_i=2
  l_i=3
end]]></Code>
  </Program>
</Programs>"#;

const OLD: &str = "<programList>\n  <program name=\"p\" public=\"true\">\n    <source>\n      <code>begin\n  if a&lt;1\n    b=1\n  endIf\nend</code>\n    </source>\n  </program>\n</programList>";

#[track_caller]
fn check(base: &str, ours: &str, theirs: &str, expected: &Expect) {
    expected.assert_eq(&merged(MergedKind::Program, base, ours, theirs));
}

#[test]
fn code_is_merged_by_lines_and_locals_by_name() {
    let local = "size=\"1\" />\n";
    let ours = NEW
        .replace("l_i=1", "l_i=10")
        .replace(local, "size=\"1\" />\n      <Local name=\"l_a\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n");
    let theirs = NEW
        .replace("  l_i=3", "  l_i=3\n  l_i=4<5")
        .replace(local, "size=\"2\" />\n      <Local name=\"l_b\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n");
    check(
        NEW,
        &ours,
        &theirs,
        &expect![[r#"
        <Programs>
          <Program name="pick" access="public">
            <Parameters>
              <Parameter name="x_n" type="num" xsi:type="element" />
            </Parameters>
            <Locals>
              <Local name="l_i" type="num" xsi:type="array" size="2" />
              <Local name="l_a" type="num" xsi:type="array" size="1" />
              <Local name="l_b" type="num" xsi:type="array" size="1" />
            </Locals>
            <Code><![CDATA[begin
          l_i=10
          l_i=2
          l_i=3
          l_i=4<5
        end]]></Code>
          </Program>
        </Programs>"#]],
    );
}

#[test]
fn contradicting_lines_keep_well_formed_xml() {
    check(
        NEW,
        &NEW.replace("l_i=2", "l_i=20"),
        &NEW.replace("l_i=2", "l_i=200"),
        &expect![[r#"
        <Programs>
          <Program name="pick" access="public">
            <Parameters>
              <Parameter name="x_n" type="num" xsi:type="element" />
            </Parameters>
            <Locals>
              <Local name="l_i" type="num" xsi:type="array" size="1" />
            </Locals>
            <Code><![CDATA[begin
          l_i=1
        <<<<<<< ours
          l_i=20
        ||||||| base
          l_i=2
        =======
          l_i=200
        >>>>>>> theirs
          l_i=3
        end]]></Code>
          </Program>
        </Programs>
        ! conflict in `Code`: both sides have changed line 3
    "#]],
    );
    check(
        OLD,
        &OLD.replace("b=1", "b=2"),
        &OLD.replace("b=1", "b=3").replace("&lt;", ">"),
        &expect![[r#"
        <programList>
          <program name="p" public="true">
            <source>
              <code>begin
        &lt;&lt;&lt;&lt;&lt;&lt;&lt; ours
          if a&lt;1
            b=2
        ||||||| base
          if a&lt;1
            b=1
        =======
          if a&gt;1
            b=3
        &gt;&gt;&gt;&gt;&gt;&gt;&gt; theirs
          endIf
        end</code>
            </source>
          </program>
        </programList>
        ! conflict in `code`: both sides have changed line 2
    "#]],
    );
    check(
        OLD,
        &OLD.replace("begin", "Begin"),
        &OLD.replace("begin", "BEGIN"),
        &expect![[r#"
        <programList>
          <program name="p" public="true">
            <source>
              <code>
        &lt;&lt;&lt;&lt;&lt;&lt;&lt; ours
        Begin
        ||||||| base
        begin
        =======
        BEGIN
        &gt;&gt;&gt;&gt;&gt;&gt;&gt; theirs
          if a&lt;1
            b=1
          endIf
        end</code>
            </source>
          </program>
        </programList>
        ! conflict in `code`: both sides have changed line 2
    "#]],
    );
}

fn with_last_parameter(name: &str) -> String {
    let parameter = format!("<Parameter name=\"{name}\" type=\"num\" xsi:type=\"element\" />");
    NEW.replace(" />\n    </Parameters>", &format!(" />\n      {parameter}\n    </Parameters>"))
}

#[test]
fn the_order_of_parameters_counts() {
    let first = NEW.replace(
        "      <Parameter name=\"x_n\"",
        "      <Parameter name=\"x_0\" type=\"num\" xsi:type=\"element\" />\n      <Parameter name=\"x_n\"",
    );
    assert_eq!(
        merge(MergedKind::Program, NEW, &NEW.replace("l_i=1", "l_i=7"), &first).text,
        first.replace("l_i=1", "l_i=7")
    );
    check(
        NEW,
        &with_last_parameter("x_a"),
        &with_last_parameter("x_b"),
        &expect![[r#"
        <Programs>
          <Program name="pick" access="public">
            <!-- <<<<<<< conflict in `Parameters`: both sides have changed the list, whose order counts
        ||||||| base
        <Parameters>
          <Parameter name="x_n" type="num" xsi:type="element" />
        </Parameters>
        ======= theirs
        <Parameters>
          <Parameter name="x_n" type="num" xsi:type="element" />
          <Parameter name="x_b" type="num" xsi:type="element" />
        </Parameters>
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
            <Parameters>
              <Parameter name="x_n" type="num" xsi:type="element" />
              <Parameter name="x_a" type="num" xsi:type="element" />
            </Parameters>
            <Locals>
              <Local name="l_i" type="num" xsi:type="array" size="1" />
            </Locals>
            <Code><![CDATA[begin
          l_i=1
          l_i=2
          l_i=3
        end]]></Code>
          </Program>
        </Programs>
        ! conflict in `Parameters`: both sides have changed the list, whose order counts
    "#]],
    );
    let public = with_last_parameter("x_a").replace("access=\"public\"", "access=\"private\"");
    assert_eq!(merge(MergedKind::Program, NEW, &with_last_parameter("x_a"), &public).text, public);
}
