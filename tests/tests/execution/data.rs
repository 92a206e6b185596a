//! Data and variables (2.3 to 2.5).

use expect_test::expect;

use crate::execution::check;

#[test]
fn variables_have_their_first_values() {
    check(
        r#"
        bool bFlag
        num nValue
        string sText
        trsf trShift
        point pPart
        program start()
          bool l_bFlag
          num l_nValue[2]
          string l_sText
        begin
          ? bFlag or l_bFlag
          ? nValue+l_nValue[1]
          ? sText+l_sText+"."
          trShift={100,-50,200,0,0,0}
          ? trShift.y
          trShift={1,,3,,,}
          ? trShift.y
          pPart={{100,-50,200,0,0,0},{sfree,efree,wfree}}
          ? pPart.trsf.z
          pPart.trsf={7,,,,,}
          ? pPart.trsf.x+pPart.trsf.z
        end
        "#,
        expect![[r#"
            false
            0
            .
            -50
            0
            200
            7
        "#]],
    );
}

#[test]
fn a_local_hides_a_global() {
    check(
        r#"
        num nValue=5
        program other()
        begin
          ? nValue
        end
        program start()
          num nValue
        begin
          nValue=7
          ? nValue
          call other()
        end
        "#,
        expect![[r#"
            7
            5
        "#]],
    );
}

#[test]
fn an_index_is_rounded() {
    check(
        r#"
        num n2d[6,8]
        num nArray[3]
        program start()
        begin
          n2d[5.01,6.99]=4
          ? n2d[5,7]
          nArray=1
          nArray[0.5]=2
          nArray[1.5]=3
          ? nArray[-0.5]*100+nArray[1]*10+nArray[2.49]
        end
        "#,
        expect![[r#"
            4
            123
        "#]],
    );
}

#[test]
fn size_returns_the_sizes() {
    check(
        r#"
        num nValue
        num nArray[7]
        num n3d[2,3,4]
        num nColl["x","y"]
        program start()
        begin
          ? size(nValue)
          ? size(nArray)
          ? size(nArray,1)
          ? size(nArray,2)
          ? size(nArray[2])
          ? size(nArray[6])
          ? size(n3d,1)*100+size(n3d,2)*10+size(n3d,3)
          ? size(n3d,4)
          ? size(nColl)
        end
        "#,
        expect![[r#"
            1
            7
            7
            0
            5
            1
            234
            0
            2
        "#]],
    );
}

#[test]
fn is_defined_of_elements_and_keys() {
    check(
        r#"
        num nArray[3]
        num n2d[2,2]
        num nColl["x"]
        program start()
        begin
          ? isDefined(nArray[2])
          ? isDefined(nArray[3])
          ? isDefined(nArray[-1])
          ? isDefined(n2d[1,1])
          ? isDefined(n2d[1,2])
          ? isDefined(nColl["x"])
          ? isDefined(nColl["y"])
        end
        "#,
        expect![[r#"
            true
            false
            false
            true
            false
            true
            false
        "#]],
    );
}

#[test]
fn values_are_inserted_into_and_deleted_from_arrays() {
    check(
        r#"
        num nArray[2]
        string sSeen
        program show()
          num l_n
        begin
          sSeen=""
          for l_n=0 to size(nArray)-1
            sSeen=sSeen+toString("",nArray[l_n])+" "
          endFor
          ? sSeen
        end
        program start()
        begin
          nArray[0]=1
          nArray[1]=2
          insert(nArray[1])
          call show()
          insert(nArray[size(nArray)])
          call show()
          nArray[3]=9
          append(nArray)
          call show()
          delete(nArray[0])
          call show()
          resize(nArray,1,2)
          call show()
          resize(nArray,1,3)
          call show()
        end
        "#,
        expect![[r#"
            1 0 2
            1 0 2 0
            1 0 2 9 0
            0 2 9 0
            0 2
            0 2 0
        "#]],
    );
}

#[test]
fn values_are_inserted_into_and_deleted_from_collections() {
    check(
        r#"
        string sColl["mid"]
        string sKey
        program start()
        begin
          ? insert(sColl["zeta"])
          ? insert(sColl["alpha"])
          ? insert(sColl["mid"])
          sKey=first(sColl)
          while sKey!=""
            ? sKey
            sKey=next(sColl[sKey])
          endWhile
          sKey=last(sColl)
          while sKey!=""
            ? sKey
            sKey=prev(sColl[sKey])
          endWhile
          delete(sColl["mid"])
          delete(sColl["zeta"])
          delete(sColl["alpha"])
          ? size(sColl)
          ? first(sColl)+last(sColl)+"."
        end
        "#,
        expect![[r#"
            true
            true
            false
            alpha
            mid
            zeta
            zeta
            mid
            alpha
            0
            .
        "#]],
    );
}

#[test]
fn the_size_of_a_dimension_keeps_the_values() {
    check(
        r#"
        num n2d[2,3]
        program start()
        begin
          n2d[1,2]=12
          n2d[1,1]=11
          resize(n2d,2,5)
          ? size(n2d,2)
          ? n2d[1,2]+n2d[1,4]
          resize(n2d,2,2)
          ? n2d[1,1]
          resize(n2d,2,3)
          ? n2d[1,2]
        end
        "#,
        expect![[r#"
            5
            12
            11
            0
        "#]],
    );
}

#[test]
fn data_are_read_by_name() {
    check(
        r#"
        num nSource[4]
        num nGoal[3]
        string sText
        num nPath[8]
        num nGot
        program start()
        begin
          nSource[0]=1
          nSource[1]=2
          nSource[2]=3
          nSource[3]=4
          ? getData("nSource",nGoal)
          ? nGoal[2]
          ? getData("nSource[2]",nGoal)
          ? nGoal[0]*100+nGoal[1]*10+nGoal[2]
          nGot=getData("nSource",nPath)
          nGot=nGot+getData("nGoal",nPath[nGot])
          ? nGot
          ? nPath[4]
          ? getData("nNothing",nGoal)
          ? getData("part:nSource",nGoal)
          ? getData("nSource[4]",nGoal)
          ? getData("sText",nGoal)
        end
        "#,
        expect![[r#"
            3
            3
            2
            343
            7
            3
            -1
            -2
            -3
            -4
        "#]],
    );
}
