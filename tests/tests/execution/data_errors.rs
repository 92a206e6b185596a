//! Run-time errors of values and variables: 10, 11, 20, 21, 40 and 70 (2.5, 3.2, 12.1).

use expect_test::expect;

use crate::execution::errors;

#[test]
fn a_division_by_zero_is_error_10() {
    errors(
        "num nZero",
        &["l_nValue=1/nZero", "l_nValue=1%nZero", "l_nValue=nZero/1", "l_nValue=nZero%1"],
        expect![[r#"
            10 l_nValue=1/nZero
            10 l_nValue=1%nZero
            -1 l_nValue=nZero/1
            -1 l_nValue=nZero%1
        "#]],
    );
}

#[test]
fn numbers_outside_the_domain_of_a_function_are_error_11() {
    errors(
        "num nOne=1\nnum nZero",
        &[
            "l_nValue=sqrt(nZero)",
            "l_nValue=sqrt(-nOne)",
            "l_nValue=ln(nOne)",
            "l_nValue=ln(nZero)",
            "l_nValue=ln(-nOne)",
            "l_nValue=log(nZero)",
            "l_nValue=asin(nOne)",
            "l_nValue=asin(nOne+0.001)",
            "l_nValue=acos(-nOne)",
            "l_nValue=acos(-nOne-0.001)",
            "l_nValue=exp(nOne*1000)",
            "l_nValue=power(nOne*10,1000)",
            "l_nValue=power(-nOne,2)",
        ],
        expect![[r#"
            -1 l_nValue=sqrt(nZero)
            11 l_nValue=sqrt(-nOne)
            -1 l_nValue=ln(nOne)
            11 l_nValue=ln(nZero)
            11 l_nValue=ln(-nOne)
            11 l_nValue=log(nZero)
            -1 l_nValue=asin(nOne)
            11 l_nValue=asin(nOne+0.001)
            -1 l_nValue=acos(-nOne)
            11 l_nValue=acos(-nOne-0.001)
            11 l_nValue=exp(nOne*1000)
            11 l_nValue=power(nOne*10,1000)
            11 l_nValue=power(-nOne,2)
        "#]],
    );
}

#[test]
fn indexes_out_of_range_are_errors() {
    errors(
        "num nMinus=-1\nnum nTwo=2\nnum nArray[2]\nnum n2d[2,3]\nnum nColl[\"a\"]\nstring sEmpty",
        &[
            "nArray[nTwo-1]=1",
            "nArray[1.49]=1",
            "nArray[1.5]=1",
            "nArray[nTwo]=1",
            "nArray[-0.5]=1",
            "nArray[-0.51]=1",
            "nArray[nMinus]=1",
            "l_nValue=nArray[nTwo]",
            "l_nValue=n2d[1,2]",
            "l_nValue=n2d[1,3]",
            "l_nValue=n2d[nTwo,0]",
            "l_nValue=n2d[0,nMinus]",
            "l_nValue=nColl[\"a\"]",
            "l_nValue=nColl[\"b\"]",
            "nColl[\"b\"]=1",
            "l_nValue=size(nArray[nTwo])",
            "l_nValue=size(nArray[nMinus])",
        ],
        expect![[r#"
            -1 nArray[nTwo-1]=1
            -1 nArray[1.49]=1
            20 nArray[1.5]=1
            20 nArray[nTwo]=1
            -1 nArray[-0.5]=1
            21 nArray[-0.51]=1
            21 nArray[nMinus]=1
            20 l_nValue=nArray[nTwo]
            -1 l_nValue=n2d[1,2]
            20 l_nValue=n2d[1,3]
            20 l_nValue=n2d[nTwo,0]
            21 l_nValue=n2d[0,nMinus]
            -1 l_nValue=nColl['a']
            20 l_nValue=nColl['b']
            20 nColl['b']=1
            20 l_nValue=size(nArray[nTwo])
            21 l_nValue=size(nArray[nMinus])
        "#]],
    );
}

#[test]
fn impossible_insertions_and_deletions_are_errors() {
    errors(
        "num nMinus=-1\nnum nTwo=2\nnum nArray[2]\nnum nOne[1]\nnum nColl[\"a\"]\nstring sEmpty",
        &[
            "insert(nArray[nTwo])",
            "insert(nArray[nTwo+2])",
            "insert(nArray[nMinus])",
            "delete(nOne[0])",
            "delete(nArray[nTwo+1])",
            "delete(nArray[nMinus])",
            "delete(nColl[\"b\"])",
            "delete(nColl[\"a\"])",
            "l_bFlag=insert(nColl[sEmpty])",
            "resize(nArray,1,0)",
            "resize(nArray,1,-1)",
            "resize(nArray,2,3)",
        ],
        expect![[r#"
            -1 insert(nArray[nTwo])
            20 insert(nArray[nTwo+2])
            21 insert(nArray[nMinus])
            70 delete(nOne[0])
            20 delete(nArray[nTwo+1])
            21 delete(nArray[nMinus])
            20 delete(nColl['b'])
            -1 delete(nColl['a'])
            70 l_bFlag=insert(nColl[sEmpty])
            70 resize(nArray,1,0)
            70 resize(nArray,1,-1)
            70 resize(nArray,2,3)
        "#]],
    );
}

#[test]
fn a_variable_has_9999_values() {
    errors(
        "num nArray[9998]\nnum n2d[1,1]",
        &[
            "append(nArray)",
            "append(nArray)",
            "insert(nArray[0])",
            "l_nValue=nArray[9998]",
            "l_nValue=nArray[9999]",
            "resize(nArray,1,9999)",
            "resize(nArray,1,10000)",
            "resize(n2d,1,100)",
            "resize(n2d,2,99)",
            "resize(n2d,2,100)",
        ],
        expect![[r#"
            -1 append(nArray)
            40 append(nArray)
            40 insert(nArray[0])
            -1 l_nValue=nArray[9998]
            20 l_nValue=nArray[9999]
            -1 resize(nArray,1,9999)
            40 resize(nArray,1,10000)
            -1 resize(n2d,1,100)
            -1 resize(n2d,2,99)
            40 resize(n2d,2,100)
        "#]],
    );
}

#[test]
fn a_collection_has_9999_values() {
    errors(
        "num nColl[\"0\"]",
        &[
            "for l_nValue=1 to 9998\n    insert(nColl[toString(\"\",l_nValue)])\n  endFor",
            "insert(nColl[\"9998\"])",
            "insert(nColl[\"9999\"])",
            "delete(nColl[\"0\"])\n  insert(nColl[\"9999\"])",
        ],
        expect![[r#"
            -1 for l_nValue=1 to 9998;   insert(nColl[toString('',l_nValue)]); endFor
            -1 insert(nColl['9998'])
            40 insert(nColl['9999'])
            -1 delete(nColl['0']); insert(nColl['9999'])
        "#]],
    );
}
