//! Completions in strings, in the old dialect and in attributes, and positions without completions.

use expect_test::expect;

use super::{LIBRARY, check, check_nothing};

#[test]
fn strings_are_completed_by_their_use() {
    let part = |line: &str| format!("library part \"Disk://part/part.pjx\"\nnum nA\n{line}{LIBRARY}");
    check(
        &part("nA=part:libLoad(\"$0\")"),
        expect![[r#"
        Disk://part Path library, fits the interface
    "#]],
    );
    check(
        &part("if part:libExist(\"$0\""),
        expect![[r#"
        nWeight Data num
        pick() Program program
    "#]],
    );
    check(
        "taskCreate \"reader\",10,run()\ntaskKill(\"$0\")\nprogram run()\nbegin\nend",
        expect![[r#"
        reader Text task, runs run
    "#]],
    );
    check(
        "num nA[2]\nnum nB\nnB=toBinary(nA,1,\"-4$0\",nA)",
        expect![[r#"
        -4l Text binary format
        -4b Text binary format
    "#]],
    );
    check(
        "string sA\nsA=getDate(\"%Y-%$0 %H\")",
        expect![[r#"
        %y Text part of the date
        %Y Text part of the date
        %m Text part of the date
        %d Text part of the date
        %H Text part of the date
        %I Text part of the date
    "#]],
    );
    check(
        "sio siA\nnum nA\nnA=sioCtrl(siA,\"ba$0\",9600)",
        expect![[r#"
        baudRate Text parameter
    "#]],
    );
    check(
        "sio siA\nnum nA\nnA=sioCtrl(siA,\"parity\",\"$0",
        expect![[r#"
        none Text value
        even Text value
        odd Text value
    "#]],
    );
    check(
        "dio diIn[\"door\",\"lamp\"]\nwait(diIn[\"$0\"])",
        expect![[r#"
            door Text key
            lamp Text key
        "#]],
    );
    check(
        "num nA\npoint pA\nnum nB\nnB=getData(\"$0\",pA)",
        expect![[r#"
        pA Data pointRx
    "#]],
    );
    check_nothing("putln(\"mov$0\")");
}

/// A cell with two libraries for one interface, an unrelated project, and another cell with a library of the same name.
fn libraries(code: &str) -> String {
    let other =
        "<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters version=\"s7.11\" /></Project>";
    format!(
        "library part \"Disk://part/part.pjx\" autoload=false\nnum nA\ncall part:pick(1)\n{code}{LIBRARY}\n\
         --- whole\npublic num nWeight\npublic program pick(num x_n)\nbegin\nend\n\
         --- apart\npublic num nOther\n--- zused\npublic program pick(num x_n)\nbegin\nend\n\
         === /other/usr/usrapp/part/part.pjx\n{other}\n=== /other/usr/usrapp/afar/afar.pjx\n{other}\n\
         === _odd/odd.pjx\n{other}\n"
    )
}

#[test]
fn suitable_libraries_of_the_cell_come_first() {
    check(
        &libraries("nA=part:libLoad(\"$0\")"),
        expect![[r#"
            Disk://part Path library, fits the interface
            Disk://whole Path library, fits the interface
            Disk://zused Path library with all used items of the interface
            Disk://_odd/odd.pjx Path library
            Disk://apart Path library
        "#]],
    );
    check_nothing(&libraries("af$0"));
    check(
        &libraries("").replace("call part:pick(1)", "nA=whole:$0"),
        expect![[r#"
            nWeight Data num
        "#]],
    );
}

#[test]
fn nothing_is_proposed_where_no_name_fits() {
    check_nothing("cls()\n// no$0\ncls()");
    check_nothing("num nA\nnA=12$0");
    check_nothing("return $0");
    check_nothing(
        "num nOther\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code><![CDATA[begin\nend\n$0]]></Code></Program></Programs>",
    );
    check_nothing("num nOther\n=== main/start.pgx\n<Programs><!-- w$0 --></Programs>");
}

#[test]
fn escaped_code_is_completed() {
    check(
        &with_escaped_line("if sA&lt;$0"),
        expect![[r#"
        sA Data string
        chr Instruction string chr(num nCodePoint)
        delete Instruction string delete(string sText, num nSize, num nPosition)
        first Instruction string first(T& variable[""])
        getDate Instruction string getDate(string sFormat)
        getLanguage Instruction string getLanguage()
    "#]],
    );
    check(
        &with_escaped_line("sA=getDate(&quot;%$0&quot;)"),
        expect![[r#"
        %y Text part of the date
        %Y Text part of the date
        %m Text part of the date
        %d Text part of the date
        %H Text part of the date
        %I Text part of the date
    "#]],
    );
}

/// A cell with this line in the code of `start`, which is not in a CDATA section.
fn with_escaped_line(line: &str) -> String {
    format!(
        "string sA\nmdesc mA\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code>begin\n{line}\nend</Code></Program></Programs>"
    )
}

#[test]
fn values_of_attributes_are_completed() {
    check(
        &with_declarations("<Locals><Local name=\"l_n\" type=\"po$0\" /></Locals>"),
        expect![[r#"
        point Type
    "#]],
    );
    check(
        &with_declarations("<Parameters><Parameter name=\"x_n\" use=\"$0\" /></Parameters>"),
        expect![[r#"
        value Keyword
        reference Keyword
    "#]],
    );
    check(
        &with_data("<Data name=\"pA\" type=\"pointRx\"><Value key=\"0\" fatherId=\"$0\" /></Data>"),
        expect![[r#"
        fTable[0] Data frame
        world[0] Constant frame
    "#]],
    );
    check(
        &with_data("<Data name=\"mA\" type=\"mdesc\"><Value key=\"0\" blend=\"$0\" /></Data>"),
        expect![[r#"
        joint Keyword
        off Keyword
        cartesian Keyword
    "#]],
    );
    check(
        &with_data("<Data name=\"mA\" xsi:type=\"$0\" />"),
        expect![[r#"
        array Keyword
        collection Keyword
    "#]],
    );
    check(
        "cls()\n=== main/more.pgx\n<Programs />\n=== main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /><Program file=\"$0\" /></Programs></Project>",
        expect![[r#"
        more.pgx Path
        start.pgx Path
    "#]],
    );
    check(
        &format!(
            "cls()\n=== main/main.pjx\n<Project><Libraries><Library alias=\"part\" path=\"$0\" /></Libraries></Project>{LIBRARY}"
        ),
        expect![[r#"
        Disk://part/part.pjx Path
    "#]],
    );
}

/// A cell with these elements before the code of `start`.
fn with_declarations(elements: &str) -> String {
    format!(
        "num nOther\n=== main/start.pgx\n<Programs><Program name=\"start\">{elements}<Code><![CDATA[begin\nend]]></Code></Program></Programs>"
    )
}

/// A cell with a second data file that contains these elements.
fn with_data(elements: &str) -> String {
    format!(
        "cls()\nframe fTable\n=== main/more.dtx\n<Database><Datas>{elements}</Datas></Database>\n=== main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /></Programs><Database><Data file=\"main.dtx\" /><Data file=\"more.dtx\" /></Database></Project>"
    )
}
