mod position;
mod xml;

use expect_test::{Expect, expect};

use super::*;
use crate::testing::MarkedListing;

fn check(listing: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let found = hover(marked.db(), marked.at()).map_or_else(|| "nothing".to_owned(), |hover| hover.markdown);
    expected.assert_eq(&(found + "\n"));
}

#[test]
fn variables_show_their_declaration() {
    check(
        "num nCount = 3\nnC$0ount=1",
        expect![[r#"
        ```val3
        num nCount
        ```

        starts as
        ```val3
        3
        ```

    "#]],
    );
    check(
        "string sName = \"box\"\nput(sNam$0e)",
        expect![[r#"
        ```val3
        string sName
        ```

        starts as
        ```val3
        box
        ```

    "#]],
    );
    check(
        "frame fTable\npoint pA\npA.trsf=fTa$0ble.trsf",
        expect![[r#"
            ```val3
            frame fTable
            ```

            father: `world`

            in `world`: x=0 y=0 z=0 mm, rx=0 ry=0 rz=0 degrees

        "#]],
    );
    check(
        "program start(num& x_n)\nbegin\n  put(x_n$0)\nend",
        expect![[r#"
        ```val3
        num& x_n
        ```

        parameter, by reference
    "#]],
    );
    check(
        "program start()\n  num l_a[3]\nbegin\n  put(l_$0a[1])\nend",
        expect![[r#"
        ```val3
        num l_a[3]
        ```

        local variable
    "#]],
    );
}

#[test]
fn programs_show_their_comment() {
    check(
        "call gr$0ip(1)\nprogram grip(num x_n, string& x_s)\nbegin\n  // Closes the gripper.\n  //\\param x_n how hard\n  putln(x_n)\nend",
        expect![[r#"
            ```val3
            program grip(num x_n, string& x_s)
            ```

            Closes the gripper.
            - `x_n`: how hard
        "#]],
    );
}

#[test]
fn libraries_and_types_show_their_path() {
    check(
        "library part \"Disk://part/part.pjx\"\npa$0rt:nA=1\n--- part\npublic num nA",
        expect![[r#"
        ```val3
        library part
        ```

        interface of `Disk://part/part.pjx`, loaded with the application
    "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sA\nput(sA.nHei$0ght)\n--- Slot\npublic num nHeight = 4",
        expect![[r#"
        ```val3
        public num nHeight
        ```

        starts as
        ```val3
        4
        ```

    "#]],
    );
}

#[test]
fn words_of_the_language_show_their_page() {
    check(
        "num nA\nnA=sqr$0t(4)",
        expect![[r#"
        ```val3
        num sqrt(num nValue)
        ```

        Returns the square root of a number.

        - `nValue`: 0 or more.
        - Result: the root.
        - Error 11: `nValue` is negative.

        ## Example
        ```val3
        num nDistance
        trsf trGap
          nDistance=sqrt(trGap.x*trGap.x+trGap.y*trGap.y)
        ```

    "#]],
    );
    check(
        "point pA\npA.trsf.r$0x=1",
        expect![[r#"
        ```val3
        num trsf.rx
        ```

        First rotation, about x. (degrees)
    "#]],
    );
    check(
        "if tr$0ue\nendIf",
        expect![[r#"
        The two truth values.

        ## Example
        ```val3
        bool bDone
          bDone=true
          wait(bDone)
        ```

    "#]],
    );
    check(
        "whi$0le true\n  delay(1)\nendWhile",
        expect![[r#"
        Repeats lines as long as a condition holds.

        The condition is computed before each pass, so the lines may not be executed at all. A loop that waits for
        something needs a `delay` or another instruction that lets the other tasks run.

        ## Example
        ```val3
        dio doLamp
          while isSettled()==false
            doLamp=!doLamp
            delay(0.5)
          endWhile
          doLamp=false
        ```

    "#]],
    );
    check(
        "mdesc mA\nmA.blend=jo$0int",
        expect![[r#"
        ```val3
        blend joint
        ```

        Rounds the corner with a joint move: fast, free in shape.
    "#]],
    );
}

#[test]
fn constants_show_their_value() {
    check(
        "num nA\nnA=2*$0(3+4)",
        expect![[r#"
        ```val3
        14
        ```

    "#]],
    );
}

#[test]
fn numbers_show_their_meaning() {
    check(
        "num nA\nif taskStatus(\"a\")==3$00\nendIf",
        expect![[r#"
        ```val3
        30 no such task
        ```

        run-time error. This application or library has created no task of this name, or it has ended. Ask taskStatus before; a task of another library cannot be reached.
    "#]],
    );
    check(
        "num nA\nif -$01==taskStatus(\"a\")\nendIf",
        expect![[r#"
        ```val3
        -1 there is no task of this name
        ```

        state of a task
    "#]],
    );
    check(
        "num nA\nnA=taskStatus(\"a\")\nif nA==2$00\nendIf",
        expect![[r#"
            ```val3
            20 index too large
            ```

            run-time error. A line uses an element of an array whose index is not below the size of the array, or of a collection that does not have the key. Compare the index with size, or ask isDefined for the key.
        "#]],
    );
    check(
        "num nA\nnA=getKey()\nswitch nA\ncase 27$01\nbreak\nendSwitch",
        expect![[r#"
        ```val3
        271 F1
        ```

        key of the pendant
    "#]],
    );
    check(
        "library part \"Disk://part/part.pjx\"\nif part:libLoad(\"Disk://part\")!=1$01\nendIf",
        expect![[r#"
        ```val3
        11 loaded, interface differs
        ```

        The library is loaded but lacks public data or programs that the identifier promises; their use raises run-time error 80. Ask libExist or isDefined before, or adapt the library.
    "#]],
    );
    check(
        "num nA\nif nA==3$00\nendIf",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn values_show_units_and_fathers() {
    let data = "pA.trsf.x=1\nmA.vel=1\n=== main/main.dtx\n<Database><Datas>\n<Data name=\"fCell\" type=\"frame\" size=\"1\"><Value key=\"0\" x=\"1\" fatherId=\"world[0]\" /></Data>\n<Data name=\"fTables\" type=\"frame\" size=\"2\"><Value key=\"0\" fatherId=\"world[0]\" /><Value key=\"1\" y=\"2\" fatherId=\"fCell[0]\" /></Data>\n<Data name=\"pA\" type=\"pointRx\" size=\"1\"><Value key=\"0\" x=\"10.5\" rz=\"90\" shoulder=\"lefty\" fatherId=\"fTables[1]\" /></Data>\n<Data name=\"mA\" type=\"mdesc\" size=\"1\"><Value key=\"0\" vel=\"50\" tmax=\"250\" leave=\"3\" /></Data></Datas></Database>";
    check(
        &data.replace("pA.", "p$0A."),
        expect![[r#"
            ```val3
            pointRx pA
            ```

            starts as
            ```val3
            x=10.5 mm rz=90° shoulder=lefty
            ```

            father: `fTables[1]`, on `fCell`, on `world`

            in `world`: x=11.5 y=2 z=0 mm, rx=0 ry=0 rz=90 degrees

            at the start; a program changes it or one of its fathers

        "#]],
    );
    check(
        &data.replace("mA.", "m$0A."),
        expect![[r#"
        ```val3
        mdesc mA
        ```

        starts as
        ```val3
        vel=50 % tmax=250 mm/s leave=3 mm
        ```

    "#]],
    );
    check(
        &data.replace("tmax", "tm$0ax"),
        expect![[r#"
        ```val3
        mdesc.tvel
        ```

        Highest speed of the tool centre point. (mm per second)
    "#]],
    );
    check(
        &data.replace("=\"lefty", "=\"le$0fty"),
        expect![[r#"
            ```val3
            point.config.shoulder
            ```

            Side on which the shoulder stands.

            `lefty`: The arm stands on the left of the point.

            in `world`: x=11.5 y=2 z=0 mm, rx=0 ry=0 rz=90 degrees

            at the start; a program changes it or one of its fathers

        "#]],
    );
    check(
        &data.replace("type=\"mdesc", "type=\"md$0esc"),
        expect![[r#"
            ```val3
            mdesc
            ```

            A motion descriptor: speed, acceleration and blending of a move.

            - `accel`: num, in per cent of the arm's nominal value. Highest joint acceleration.
            - `vel`: num, in per cent of the arm's nominal value. Highest joint speed.
            - `decel`: num, in per cent of the arm's nominal value. Highest joint deceleration.
            - `tvel`: num, in mm per second. Highest speed of the tool centre point.
            - `rvel`: num, in degrees per second. Highest turning speed of the tool centre point.
            - `blend`: blend. How the path is rounded at the target.
            - `leave`: num, in mm. Distance before the target at which blending starts.
            - `reach`: num, in mm. Distance after the target at which blending ends.
        "#]],
    );
    check(
        &data.replace("fatherId=\"fCell", "fatherId=\"fCe$0ll"),
        expect![[r#"
            ```val3
            frame fCell
            ```

            starts as
            ```val3
            x=1 mm
            ```

            father: `world`

            in `world`: x=1 y=0 z=0 mm, rx=0 ry=0 rz=0 degrees

        "#]],
    );
}

#[test]
fn arrays_collections_and_user_types_show_their_values() {
    check(
        "string sA[3] = \"a\"\nput(s$0A[1])",
        expect![[r#"
        ```val3
        string sA[3]
        ```

        starts as
        ```val3
        [0] a
        ```

    "#]],
    );
    check(
        "dio dIn[\"door\"]\nwait(d$0In[\"door\"])",
        expect![[r#"
        ```val3
        dio dIn[""]
        ```

    "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\ncls()\nSlot sOther\n=== main/main.dtx\n<Database><Datas><Data name=\"sA$0\" type=\"Slot\" size=\"1\"><Value key=\"0\"><Field name=\"nHeight\" type=\"num\"><Value key=\"0\" value=\"4\" /></Field></Value></Data></Datas></Database>\n--- Slot\npublic num nHeight",
        expect![[r#"
            ```val3
            Slot sA
            ```

            starts as
            ```val3
            nHeight=4
            ```

        "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\nprogram start()\n  Slot l_s\nbegin\n  put(l_$0s.nHeight)\nend\n--- Slot\npublic num nHeight",
        expect![[r#"
        ```val3
        Slot l_s
        ```

        local variable
    "#]],
    );
}

#[test]
fn comments_describe_parameters_and_programs() {
    check(
        "program start(num x_n)\nbegin\n  //\\param x_n how hard\n  put(x_$0n)\nend",
        expect![[r#"
        ```val3
        num x_n
        ```

        parameter, by value

        how hard
    "#]],
    );
    check(
        "num nOther\n=== main/start.pgx\n<Programs><Program name=\"st$0art\"><Description><![CDATA[// Runs it all.]]></Description><Code><![CDATA[begin\nend]]></Code></Program></Programs>",
        expect![[r#"
            ```val3
            program start()
            ```

            Runs it all.
        "#]],
    );
}

/// An image in a cloned program would be loaded when the pointer is on the program's name.
#[test]
fn comments_names_and_values_are_no_markdown() {
    check(
        "call gr$0ip(1)\nprogram grip(num x_n)\nbegin\n  // ![t](https://host/x.png) <value> *2* [a](command:x)\n  //\\param x_n`<b> how\n  // # no title\nend",
        expect![[r#"
            ```val3
            program grip(num x_n)
            ```

            !\[t](https\://host/x.png) \<value> \*2\* \[a](command:x)
            - ``x_n`<b>``: how
            \# no title
        "#]],
    );
    check(
        "num nOther\n=== main/start.pgx\n<Programs><Program name=\"st$0art\"><Description>&lt;img src=x&gt;\n```\n![t](x)</Description><Code><![CDATA[begin\nend]]></Code></Program></Programs>",
        expect![[r#"
            ```val3
            program start()
            ```

            \<img src=x>

            !\[t](x)
        "#]],
    );
}

#[test]
fn other_positions_have_no_hover() {
    check(
        "num nA\nnA=$0 1",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "cls()\n// wh$0ile\ncls()",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "put(\"whi$0le\")",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "put(nUn$0known)",
        expect![[r#"
        nothing
    "#]],
    );
}
