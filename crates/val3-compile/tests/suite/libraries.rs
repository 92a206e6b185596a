//! Libraries that programs load, save, list and delete (6.6, 6.7).

use expect_test::{Expect, expect};

use crate::cell::Cell;

#[track_caller]
fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&Cell::new(listing).run());
}

#[test]
fn two_identifiers_share_one_library_in_memory() {
    check(
        r#"
        library lib1 "Disk://appData/appData.pjx" autoload=false
        library lib2 "Disk://appData/appData.pjx" autoload=false
        program start()
        begin
          ? lib1:libLoad("appData")
          lib1:sText="lib1"
          ? lib2:libLoad("Disk://APPDATA/appData.pjx")
          ? lib2:sText
          lib2:sText="lib2"
          ? lib1:sText
        end
        --- appData
        public string sText
        "#,
        expect![[r#"
            0
            0
            lib1
            lib2
        "#]],
    );
}

#[test]
fn nothing_of_a_library_can_be_used_before_it_is_loaded() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? isDefined(part:nWeight)
          ? part:libExist("nWeight")
          ? part:libPath()
          ? part:libSave()
          ? part:nWeight
        end
        --- part
        public num nWeight
        "#,
        expect![[r#"
            false
            false

            10
            error 80 in start
        "#]],
    );
}

#[test]
fn an_identifier_stands_for_any_library_with_its_interface() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("bolt")
          ? part:nWeight
          call part:init()
          ? part:libPath()
          ? part:libLoad("./nut")
          ? part:nWeight
          ? part:libPath()
          ? libPath()
        end
        --- part
        public num nWeight
        public program init()
        begin
        end
        --- bolt
        public num nWeight=7
        public program init()
        begin
          ? "bolt"
        end
        --- main/nut
        public num nWeight=2
        public program init()
        begin
        end
        "#,
        expect![[r#"
            0
            7
            bolt
            Disk://bolt
            0
            2
            Disk://main/nut
            Disk://main
        "#]],
    );
}

#[test]
fn items_that_an_older_version_lacks_can_be_tested_for() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        num nLoadCode
        string sLibVersion
        program start()
        begin
          nLoadCode=part:libLoad("old")
          ? nLoadCode
          if (nLoadCode==0) or (nLoadCode==11)
            if (part:libExist("sVersion")==false)
              sLibVersion="v1.0"
            else
              sLibVersion=part:sVersion
            endIf
          endIf
          ? sLibVersion
          ? isDefined(part:sVersion)
          if part:libExist("init()")==true
            call part:init()
          endIf
          ? part:libExist("init")
          ? part:libExist("hidden()")
          ? part:libExist("nHidden")
          ? part:libLoad("part")
          ? part:sVersion
          call part:init()
          ? part:libLoad("old")
          call part:init()
        end
        --- part
        public string sVersion="v2.0"
        public program init()
        begin
          ? "init"
        end
        program hidden()
        begin
        end
        --- old
        num nHidden
        program hidden()
        begin
        end
        "#,
        expect![[r#"
            11
            v1.0
            false
            false
            false
            false
            0
            v2.0
            init
            11
            error 80 in start
        "#]],
    );
}

#[test]
fn items_of_another_type_are_missing() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("other")
          ? isDefined(part:nWeight)
          ? isDefined(part:nGrid)
          ? isDefined(part:sName)
          call part:put(1)
        end
        --- part
        public num nWeight
        public num nGrid[2,2]
        public string sName
        public program put(num x_nValue)
        begin
        end
        --- other
        public string nWeight
        public num nGrid[4]
        public string sName
        public program put(num& x_nValue)
        begin
        end
        "#,
        expect![[r#"
            11
            false
            false
            true
            error 80 in start
        "#]],
    );
}

#[test]
fn the_whole_interface_is_compared() {
    let work = "public program work(num x_nOther)\nbegin\nend\n";
    let same = format!("public num nUsed=1\npublic num nUnused[7]\n{work}");
    assert_eq!(run_with_loaded(&same), "0\n1\n");
    assert_eq!(run_with_loaded(&format!("{same}public num nMore\npublic program more()\nbegin\nend\n")), "0\n1\n");
    for other in [
        format!("public num nUsed=1\n{work}"),
        format!("public num nUsed=1\nnum nUnused[2]\n{work}"),
        format!("public num nUsed=1\npublic string nUnused[2]\n{work}"),
        "public num nUsed=1\npublic num nUnused[2]\n".to_owned(),
        "public num nUsed=1\npublic num nUnused[2]\nprogram work(num x_nOther)\nbegin\nend\n".to_owned(),
        "public num nUsed=1\npublic num nUnused[2]\npublic program work()\nbegin\nend\n".to_owned(),
    ] {
        assert_eq!(run_with_loaded(&other), "11\n1\n", "{other}");
    }
}

/// Output of an application that declares the library `part` and loads this library in its place.
fn run_with_loaded(loaded: &str) -> String {
    let listing = format!(
        "library part \"Disk://part/part.pjx\" autoload=false\nprogram start()\nbegin\n  \
         ? part:libLoad(\"loaded\")\n  ? part:nUsed\nend\n\
         --- part\npublic num nUsed\npublic num nUnused[2]\nnum nPrivate\n\
         public program work(num x_nValue)\nbegin\nend\nprogram hidden()\nbegin\nend\n--- loaded\n{loaded}"
    );
    Cell::new(&listing).run()
}

#[test]
fn every_reason_has_its_code() {
    let cell = Cell::new(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("Nowhere://part")
          ? part:libLoad("USB0://none/part")
          ? part:libLoad("none")
          ? part:libLoad("a:b")
          ? part:libLoad("../../../../part")
          ? part:libLoad("faulty")
          ? part:libLoad("plain.zip")
          ? part:libLoad("part")
          ? part:libSave("part")
          ? part:libSave("Nowhere://part")
          ? part:libSave("none/none/part")
          ? part:libSave("copy")
          ? part:libSave("copy")
          ? libDelete("copy")
          ? libDelete("copy")
          ? libDelete("Nowhere://copy")
        end
        --- part
        public num nWeight
        --- faulty
        public num nWeight
        program start()
        begin
          nWeight="heavy"
        end
        "#,
    );
    cell.write("usrapp/plain.zip", "PK");
    expect![[r#"
        20
        21
        39
        22
        21
        12
        23
        0
        31
        20
        21
        0
        31
        0
        0
        20
    "#]]
    .assert_eq(&cell.run());
}

#[test]
fn a_library_with_a_task_stays() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("part")
          call part:work()
          ? part:libLoad("other")
          call part:finish()
          delay(0)
          ? part:libLoad("other")
          ? part:libPath()
        end
        --- part
        public bool bGo=true
        public program work()
        begin
          taskCreate "work",10,go()
        end
        public program finish()
        begin
          bGo=false
        end
        program go()
        begin
          while bGo
            delay(0)
          endWhile
        end
        --- other
        public bool bGo
        public program work()
        begin
        end
        public program finish()
        begin
        end
        "#,
        expect![[r#"
            0
            14
            0
            Disk://other
        "#]],
    );
}

#[test]
fn a_library_in_which_another_task_is_stays() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("part")
          taskCreate "user",10,part:work()
          delay(0.1)
          ? part:libLoad("other")
          part:bGo=false
          delay(0.1)
          ? part:libLoad("other")
        end
        --- part
        public bool bGo=true
        public program work()
        begin
          while bGo
            delay(0)
          endWhile
        end
        --- other
        public bool bGo
        public program work()
        begin
        end
        "#,
        expect![[r#"
            0
            13
            0
        "#]],
    );
}

#[test]
fn a_library_of_a_library_with_a_task_stays() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        program start()
        begin
          ? part:libLoad("part")
          call part:init()
          ? part:libLoad("other")
        end
        --- part
        library inner "Disk://inner/inner.pjx"
        public program init()
        begin
          call inner:init()
        end
        --- inner
        public program init()
        begin
          taskCreate "work",10,work()
        end
        program work()
        begin
          delay(1)
        end
        --- other
        public program init()
        begin
        end
        "#,
        expect![[r#"
            0
            14
        "#]],
    );
}

#[test]
fn a_reloaded_library_has_its_initial_values() {
    check(
        r#"
        library part "Disk://part/part.pjx"
        program start()
        begin
          part:nWeight=5
          ? part:libLoad("part")
          ? part:nWeight
          ? part:libLoad("other")
          ? part:libLoad("part")
          ? part:nWeight
        end
        --- part
        public num nWeight=1
        --- other
        public num nWeight=2
        "#,
        expect![[r#"
            0
            5
            0
            0
            1
        "#]],
    );
}

#[test]
fn a_folder_is_listed_in_an_array_that_grows() {
    check(
        r#"
        string sNames[1]
        string sGrid[1,2]
        program start()
          string l_sNames[2]
        begin
          sNames[0]="old"
          ? libList("Disk://",sNames)
          ? size(sNames)
          ? sNames[0]+" "+sNames[1]+" "+sNames[2]
          ? libList("part",l_sNames)
          ? l_sNames[0]
          ? libList("Disk://",l_sNames)
          ? l_sNames[1]
          ? libList("none",sNames)
          ? sNames[0]
          ? size(sNames)
        end
        --- part
        public num nWeight
        --- bolt
        public num nWeight
        "#,
        expect![[r#"
            true
            3
            bolt main part
            true
            part.dtx
            false
            main
            false

            3
        "#]],
    );
}

#[test]
fn library_operations_are_events() {
    let cell = Cell::new(
        r#"
        library part "Disk://part/part.pjx"
        library gone "Disk://none/none.pjx"
        library bolt "Disk://bolt/bolt.pjx" autoload=false
        program start()
        begin
          bolt:libLoad("part")
          bolt:libSave("saved")
          libSave("again")
          libDelete("saved")
        end
        --- part
        public num nWeight
        --- bolt
        public num nWeight
        "#,
    );
    expect![[r#"
        load part:Disk://part/part.pjx 0
        load gone:Disk://none/none.pjx 39
        load bolt:part 0
        save bolt:saved 0
        save :again 0
        delete :saved 0
    "#]]
    .assert_eq(&cell.library_events());
}

#[test]
fn a_reference_has_to_be_in_reach() {
    check(
        r#"
        library tray "Disk://tray/tray.pjx" autoload=false
        library part "Disk://part/part.pjx" autoload=false
        point pOwn
        program hang()
        begin
          link(pOwn,tray:fPublic)
        end
        program private()
        begin
          call tray:take(pOwn)
        end
        program undeclared()
        begin
          part:pPart=tray:pPublic
        end
        program local()
          point l_pPart
        begin
          call tray:take(l_pPart)
        end
        program start()
        begin
          ? tray:libLoad("tray")
          ? part:libLoad("part")
          call tray:init()
          taskCreate "hang",10,hang()
          taskCreate "private",10,private()
          taskCreate "undeclared",10,undeclared()
          taskCreate "local",10,local()
          delay(1)
          ? taskStatus("hang")
          ? taskStatus("private")
          ? taskStatus("undeclared")
          ? taskStatus("local")
        end
        --- tray
        public frame fPublic
        public point pPublic
        frame fPrivate
        public program init()
        begin
          link(pPublic,fPublic)
        end
        public program take(point& x_pPoint)
        begin
          link(x_pPoint,fPrivate)
        end
        --- part
        public point pPart
        "#,
        expect![[r#"
            0
            0
            error 82 in take
            error 82 in undeclared
            -1
            82
            82
            -1
        "#]],
    );
}
