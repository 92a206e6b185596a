//! Completions from other files: keys of collections, programs of tasks, items of libraries.

use expect_test::expect;

use super::{LIBRARY, check, check_insert};

#[test]
fn keys_are_completed_before_their_quotes() {
    check(
        "dio dIn[\"door\",\"lamp\"]\nbool bA\nbA=dIn[\"red\"]\nwait(dIn[$0",
        expect![[r#"
            "door" Text key
            "lamp" Text key
            "red" Text key
            chr Instruction string chr(num nCodePoint)
            delete Instruction string delete(string sText, num nSize, num nPosition)
            first Instruction string first(T& variable[""])
        "#]],
    );
    check_insert(
        "dio dIn[\"door\"]\nwait(dIn[$0])",
        "\"door\"",
        expect![[r#"
        "door"
        "door"
    "#]],
    );
    check(
        "library part \"Disk://part/part.pjx\"\nwait(part:dIn[\"$0\"])\n--- part\npublic dio dIn[\"gate\"]",
        expect![[r#"
        gate Text key
    "#]],
    );
    check_insert(
        "dio dIn[\"door\"]\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code>begin\nwait(dIn[$0])\nend</Code></Program></Programs>",
        "\"door\"",
        expect![[r#"
            &quot;door&quot;
            &quot;door&quot;
        "#]],
    );
}

#[test]
fn programs_of_tasks_are_ranked() {
    check(
        "call once()\ntaskCreate \"t\",10,$0\n\
         program once()\nbegin\nend\nprogram apart()\nbegin\nend\n\
         program watch()\nbegin\n  while true\n    delay(0)\n  endWhile\nend",
        expect![[r#"
            watch Program program watch()
            apart Program program apart()
            once Program program once()
            start Program program start()
        "#]],
    );
}

#[test]
fn items_of_libraries_are_proposed_with_their_identifier() {
    check(
        &format!("num nA\nnA=nWei$0{LIBRARY}"),
        expect![[r#"
            nWei Data new global num
            part:nWeight Data num, new library Disk://part/part.pjx
        "#]],
    );
    check_insert(
        &format!("num nA\nnA=nWei$0{LIBRARY}"),
        "part:nWeight",
        expect![[r#"
        part:nWeight
        part:nWeight
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
    check_insert(
        &format!("nWei$0{LIBRARY}"),
        "part:nWeight",
        expect![[r#"
        part:nWeight
        part:nWeight
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
    check_insert(
        &format!("call pi$0{LIBRARY}"),
        "part:pick",
        expect![[r#"
        part:pick(${1:x_n})$0
        part:pick
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
    check_insert(
        &format!("library part \"Disk://part/part.pjx\"\nnum nA\nnA=nWei$0{LIBRARY}"),
        "part:nWeight",
        expect![[r#"
            part:nWeight
            part:nWeight
        "#]],
    );
}

#[test]
fn libraries_of_s6_are_declared_in_its_format() {
    check_insert(
        &format!(
            "num nA\nnA=nWei$0{LIBRARY}\n=== main/main.pjx\n<project xmlns=\"ProjectNameSpace\">\n  <parameters version=\"s6.8\" />\n  \
             <programSection><program file=\"start.pgx\" /></programSection>\n  <dataSection><data file=\"main.dtx\" /></dataSection>\n  <aliasSection />\n</project>\n"
        ),
        "part:nWeight",
        expect![[r#"
            part:nWeight
            part:nWeight
            main.pjx: <aliasSection>
                <alias name="part" interface="part" />
              </aliasSection>
        "#]],
    );
}
