use expect_test::{Expect, expect};
use val3_analysis::db::{Db, Project};
use val3_lang::types::Container;

use super::{FileEdit, Variable, data, library, public_data};
use crate::assists::shown;
use crate::edit::SourceChange;
use crate::testing::Marked;

/// What a declaration changes in the project of the program `start`.
fn check(listing: &str, declare: impl Fn(&dyn Db, Project) -> Option<FileEdit>, expected: Expect) {
    let marked = Marked::new(listing);
    let project = crate::owner(marked.db(), marked.at().file).unwrap();
    let edit = declare(marked.db(), project);
    let change = edit.map_or_else(String::new, |edit| shown(marked.db(), &SourceChange::of([edit])));
    expected.assert_eq(&change);
}

fn several(name: &str, type_name: &str, container: Container, sizes: &[u32]) -> Variable {
    Variable { name: name.to_owned(), type_name: type_name.to_owned(), container, sizes: sizes.to_vec() }
}

const NEW: &str = "c$0ls()\n=== main/main.dtx\n<Database>\n  <Datas>\n  </Datas>\n</Database>\n";

const OLD: &str = "c$0ls()\n=== main/main.dtx\n<dataList>\n  <numSection>\n    <num name=\"nA\" public=\"false\" >\n      <valueNum index=\"0\" value=\"1\" />\n    </num>\n  </numSection>\n  <stringSection/>\n</dataList>\n";

#[test]
fn data_with_and_without_a_value() {
    let number = Variable::single("nB", "num");
    check(
        NEW,
        |db, project| data(db, project, &number, Some("1")),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="1" />
            +    </Data>
        "#]],
    );
    check(
        NEW,
        |db, project| data(db, project, &number, None),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1" />
        "#]],
    );
    check(
        "c$0ls()\n=== main/main.dtx\n<Database><Datas/></Database>\n",
        |db, project| data(db, project, &Variable::single("sA", "string"), Some("<a> & \"b\"")),
        expect![[r#"
            usrapp/main/main.dtx
            -<Database><Datas/></Database>
            +<Database><Datas><Data name="sA" access="private" xsi:type="array" type="string" size="1"><Value key="0" value="&lt;a&gt; &amp; &quot;b&quot;" /></Data></Datas></Database>
        "#]],
    );
}

#[test]
fn data_of_s6() {
    check(
        OLD,
        |db, project| data(db, project, &Variable::single("nB", "num"), Some("1")),
        expect![[r#"
            usrapp/main/main.dtx
            +    <num name="nB" public="false" >
            +      <valueNum index="0" value="1" />
            +    </num>
        "#]],
    );
    check(
        OLD,
        |db, project| data(db, project, &several("sA", "string", Container::Array { dims: 1 }, &[2]), Some("<")),
        expect![[r#"
            usrapp/main/main.dtx
            -  <stringSection/>
            +  <stringSection>
            +    <string name="sA" public="false" >
            +      <valueString index="0" value="&lt;" />
            +      <valueString index="1" value="" />
            +    </string>
            +  </stringSection>
        "#]],
    );
    // There is no section for it, and points are written otherwise.
    check(OLD, |db, project| data(db, project, &Variable::single("bA", "bool"), None), expect![""]);
    check(OLD, |db, project| data(db, project, &Variable::single("pA", "pointRx"), None), expect![""]);
}

#[test]
fn public_data_of_an_interface() {
    let variables = [
        Variable::single("pA", "pointRx"),
        several("nA", "num", Container::Array { dims: 2 }, &[2, 3]),
        several("dIn", "dio", Container::Collection, &[]),
    ];
    check(
        NEW,
        |db, project| public_data(db, project, &variables),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
            +      <Value key="0" fatherId="world[0]" />
            +    </Data>
            +    <Data name="nA" access="public" xsi:type="array" type="num" size="2 3" />
            +    <Data name="dIn" access="public" xsi:type="collection" type="dio" />
        "#]],
    );
    check(OLD, |db, project| public_data(db, project, &variables), expect![""]);
}

#[test]
fn libraries() {
    let part = |db: &dyn Db, project: Project| library(db, project, "part", "Disk://part/part.pjx");
    check(
        "c$0ls()\n=== main/main.pjx\n<Project>\n  <Programs>\n    <Program file=\"start.pgx\" />\n  </Programs>\n  <Libraries/>\n</Project>\n",
        part,
        expect![[r#"
            usrapp/main/main.pjx
            -  <Libraries/>
            +  <Libraries>
            +    <Library alias="part" path="Disk://part/part.pjx" />
            +  </Libraries>
        "#]],
    );
    check(
        "c$0ls()\n=== main/main.pjx\n<project>\n  <programSection>\n    <program file=\"start.pgx\" />\n  </programSection>\n  <aliasSection>\n    <alias name=\"io\" interface=\"Disk://io/io.pjx\" />\n  </aliasSection>\n</project>\n",
        part,
        expect![[r#"
            usrapp/main/main.pjx
            +    <alias name="part" interface="Disk://part/part.pjx" />
        "#]],
    );
}
