//! Parameters (2.6).

use expect_test::expect;

use crate::execution::check;

#[test]
fn a_value_is_copied() {
    check(
        r#"
        string sMessage
        string sArray[24]
        string s2d[13,4]
        string s3d[6,8,10]
        string sColl["name"]
        program send(string x_sText)
        begin
          x_sText=x_sText+"!"
          ? x_sText
        end
        program start()
        begin
          sArray[23]="array"
          s2d[12,3]="two"
          s3d[5,7,9]="three"
          sColl["name"]="coll"
          call send("Waiting for "+"signal")
          call send(sMessage)
          call send(sArray[23])
          call send(s2d[12,3])
          call send(s3d[5,7,9])
          call send(sColl["name"])
          ? sMessage+sArray[23]+s2d[12,3]+s3d[5,7,9]+sColl["name"]
        end
        "#,
        expect![[r#"
            Waiting for signal!
            !
            array!
            two!
            three!
            coll!
            arraytwothreecoll
        "#]],
    );
}

#[test]
fn a_reference_to_a_value_changes_it() {
    check(
        r#"
        string sMessage
        string sArray[24]
        string s2d[13,4]
        string s3d[6,8,10]
        string sColl["name"]
        program send(string& x_sText)
        begin
          x_sText=x_sText+"!"
          ? size(x_sText)
        end
        program start()
        begin
          sArray[23]="array"
          s2d[12,3]="two"
          s3d[5,7,9]="three"
          sColl["name"]="coll"
          call send(sMessage)
          call send(sArray[23])
          call send(s2d[12,3])
          call send(s3d[5,7,9])
          call send(sColl["name"])
          ? sMessage+sArray[23]+s2d[12,3]+s3d[5,7,9]+sColl["name"]
        end
        "#,
        expect![[r#"
            1
            1
            1
            1
            1
            !array!two!three!coll!
        "#]],
    );
}

#[test]
fn a_reference_to_a_container_sees_its_values() {
    check(
        r#"
        num nArray[5]
        num n2d[2,3]
        num n3d[2,3,4]
        num nColl["a","b"]
        program one(num& x_nArray[])
        begin
          ? size(x_nArray)
          x_nArray[0]=x_nArray[0]+1
        end
        program two(num& x_nArray[,])
        begin
          ? size(x_nArray,1)*10+size(x_nArray,2)
          x_nArray[1,2]=7
        end
        program three(num& x_nArray[,,])
        begin
          ? size(x_nArray,3)
          x_nArray[1,2,3]=8
        end
        program coll(num& x_nColl[""])
        begin
          ? size(x_nColl)
          insert(x_nColl["c"])
          x_nColl["c"]=9
        end
        program start()
        begin
          call one(nArray)
          call one(nArray[3])
          call two(n2d)
          call three(n3d)
          call coll(nColl)
          ? nArray[0]*10+nArray[3]
          ? n2d[1,2]
          ? n3d[1,2,3]
          ? nColl["c"]
          ? size(nColl)
        end
        "#,
        expect![[r#"
            5
            2
            23
            4
            2
            11
            7
            8
            9
            3
        "#]],
    );
}

#[test]
fn a_reference_to_a_part_can_be_made_longer() {
    check(
        r#"
        num nArray[3]
        program grow(num& x_nArray[])
        begin
          append(x_nArray)
          x_nArray[size(x_nArray)-1]=5
          ? size(x_nArray)
        end
        program start()
        begin
          call grow(nArray[1])
          ? size(nArray)
          ? nArray[3]
        end
        "#,
        expect![[r#"
            3
            4
            5
        "#]],
    );
}

#[test]
fn a_reference_passed_on_is_the_same_variable() {
    check(
        r#"
        num nArray[4]
        program inner(num& x_nArray[], num& x_nValue)
        begin
          x_nArray[0]=3
          x_nValue=x_nValue+x_nArray[0]
        end
        program outer(num& x_nArray[])
        begin
          call inner(x_nArray[1],x_nArray[1])
        end
        program start()
        begin
          call outer(nArray[1])
          ? nArray[2]
        end
        "#,
        expect![[r#"
            6
        "#]],
    );
}

/// A program with a wide frame, which many numbers need, calls programs with a narrow frame, and is called by them.
#[test]
fn frames_of_any_width_call_each_other() {
    let locals: String = (0..45).map(|number| format!("  trsf l_tr{number}\n")).collect();
    let sum: String =
        (0..45).map(|number| format!("  l_tr{number}.rz=x_nDepth\n  x_nSum=x_nSum+l_tr{number}.rz\n")).collect();
    let listing = format!(
        "program wide(num x_nDepth, num& x_nSum)\n{locals}begin\n{sum}  call narrow(x_nDepth,x_nSum)\n  \
         x_nSum=x_nSum+l_tr44.rz\nend\n\
         program narrow(num x_nDepth, num& x_nSum)\nbegin\n  if x_nDepth>1\n    call wide(x_nDepth-1,x_nSum)\n  endIf\n  \
         x_nSum=x_nSum+1000*x_nDepth\nend\n\
         program start()\n  num l_nSum\nbegin\n  call wide(2,l_nSum)\n  ? l_nSum\nend\n"
    );
    check(
        &listing,
        // 46 times 2 and 1, and 1000 times each of these.
        expect![[r#"
            3138
        "#]],
    );
}
