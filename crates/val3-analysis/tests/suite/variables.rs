//! Variables: containers, indexes, keys, constants (2.3, 2.5).

use expect_test::expect;
use val3_analysis::body::{Constant, Expr, body};

use crate::show::{faults, program, project, types, workspace};

#[test]
fn containers() {
    let listing = r#"
        num nA
        num n1[3]
        num n2[2,3]
        num n3[2,3,4]
        num nC["a"]
        string sKey
        nA=n1
        nA=n1[2]
        nA=n2[1,2]
        nA=n3[1,2,3]
        nA=nC["a"]
        nA=nC[sKey+"b"]
        nA=nA[0]
    "#;
    expect![[r#"
        nA: num | n1: num[]
        nA: num | n1: num[] | n1[2]: num
        nA: num | n2: num[,] | n2[1,2]: num
        nA: num | n3: num[,,] | n3[1,2,3]: num
        nA: num | nC: num[""] | nC["a"]: num
        nA: num | nC: num[""] | sKey: string | sKey+"b": string | nC[sKey+"b"]: num
        nA: num | nA: num | nA[0]: num
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn wrong_indexes() {
    let listing = r#"
        num nA
        num n1[3]
        num n2[2,3]
        num nC["a"]
        string sA
        bool bA
        nA=n1[1,2]
        nA=n2[1]
        nA=n2
        n2=1
        nA=nC
        nA=nC["a","b"]
        nA=nC[1]
        nA=n1[sA]
        nA=n2[1,bA]
        nA=n1[1][0]
        nA=(n1)[1]
        nA=sin(1)[0]
        bA=sA[0]==sA["x"]
        nA=n1[n2]
    "#;
    expect![[r#"
        main/start.pgx:5 `n1` IndexCount { name: "n1", expected: 1, found: 2 }
            Declared main/main.dtx:5 `n1`
        main/start.pgx:6 `n2` IndexCount { name: "n2", expected: 2, found: 1 }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:7 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:8 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:9 `nC` IndexMissing { name: "nC", ty: "num[\"\"]" }
            Declared main/main.dtx:7 `nC`
        main/start.pgx:10 `nC` IndexCount { name: "nC", expected: 1, found: 2 }
            Declared main/main.dtx:7 `nC`
        main/start.pgx:11 `1` IndexType { name: "nC", expected: "string", found: "num" }
        main/start.pgx:12 `sA` IndexType { name: "n1", expected: "num", found: "string" }
        main/start.pgx:13 `bA` IndexType { name: "n2", expected: "num", found: "bool" }
        main/start.pgx:14 `n1[1]` IndexNotAllowed { name: "n1", ty: "num", callee: None }
        main/start.pgx:15 `(n1)` IndexNotAllowed { name: "n1", ty: "num", callee: None }
        main/start.pgx:16 `sin(1)` IndexNotAllowed { name: "sin", ty: "num", callee: None }
        main/start.pgx:17 `"x"` IndexType { name: "sA", expected: "num", found: "string" }
        main/start.pgx:18 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn constant_indexes() {
    let listing = r#"
        num nA
        num nPrivate[3]
        num nGrown[3]
        num nPassed[3]
        public num nPublic[3]
        num nGrid[2,3]
        nA=nPrivate[2]
        nA=nPrivate[2.4]
        nA=nPrivate[2.5]
        nA=nPrivate[1+2]
        nA=nPrivate[-0.5]
        nA=nPrivate[-1]
        nA=nGrown[7]
        nA=nGrown[-1]
        nA=nPassed[7]
        nA=nPublic[7]
        nA=nPublic[-1]
        nA=nGrid[1,3]
        nA=nGrid[2,2]
        nA=nA[1]
        append(nGrown)
        call grow(nPassed)
        program grow(num& x_n[])
          num l_n[2]
        begin
          x_n[9]=0
          l_n[1]=l_n[2]
          if isDefined(l_n[5]) or !isDefined(nPrivate[5]) or isDefined(nPrivate[-1])
            x_n[0]=1
          endIf
        end
    "#;
    expect![[r#"
        main/grow.pgx:12 `2` IndexOutOfBounds { name: "l_n", index: 2, size: 2 }
        main/start.pgx:7 `2.5` IndexOutOfBounds { name: "nPrivate", index: 3, size: 3 }
        main/start.pgx:8 `1+2` IndexOutOfBounds { name: "nPrivate", index: 3, size: 3 }
        main/start.pgx:10 `-1` IndexOutOfBounds { name: "nPrivate", index: -1, size: 3 }
        main/start.pgx:12 `-1` IndexOutOfBounds { name: "nGrown", index: -1, size: 3 }
        main/start.pgx:15 `-1` IndexOutOfBounds { name: "nPublic", index: -1, size: 0 }
        main/start.pgx:16 `3` IndexOutOfBounds { name: "nGrid", index: 3, size: 3 }
        main/start.pgx:17 `2` IndexOutOfBounds { name: "nGrid", index: 2, size: 2 }
        main/start.pgx:18 `1` IndexOutOfBounds { name: "nA", index: 1, size: 1 }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn a_container_without_its_index_is_reported_for_its_purpose() {
    let listing = r#"
        num nA
        num n1[3]
        num n2[2,3]
        num nC["a"]
        nA=len(n1)
        nA=len(nA)
        delete(n2)
        delete(n1)
        delete(nC)
        ? n2
        ? nC
        ? n1
    "#;
    expect![[r#"
        main/start.pgx:5 `n1` ArgumentType { callee: "len", parameter: "sText", expected: ["string"], found: "num[]" }
        main/start.pgx:6 `nA` ArgumentType { callee: "len", parameter: "sText", expected: ["string"], found: "num" }
        main/start.pgx:7 `n2` ContainerMismatch { callee: "delete", parameter: "variable", expected: "num[]", found: "num[,]" }
        main/start.pgx:9 `nC` IndexMissing { name: "nC", ty: "num[\"\"]" }
        main/start.pgx:11 `nC` IndexMissing { name: "nC", ty: "num[\"\"]" }
            Declared main/main.dtx:7 `nC`
    "#]]
    .assert_eq(&faults(listing));
}

/// Number of faults for lines that read the element 5 or 2 of arrays with three and two elements.
fn index_faults(code: &str) -> usize {
    let listing = format!(
        "num nA\nnum nFew[3]\nnum nGrid[2,2]\nnum nLast\nbool bA\n\nprogram start()\n  num l_n[2]\nbegin\n{code}\nend"
    );
    faults(&listing).matches("IndexOutOfBounds").count()
}

#[test]
fn an_index_after_a_test_of_the_size_is_no_fault() {
    for code in [
        "if size(nFew)>5\nnA=nFew[5]\nendIf",
        "if size(nFew)>nA\nnA=nFew[5]\nendIf",
        "if nA>1 and (bA or size(nFew)>=nA)\nif bA\nnA=nFew[5]\nendIf\nendIf",
        "if nA==1\nelseIf size(nFew)<nA\nelse\nnA=nFew[5]\nendIf",
        "if size(nFew)<=nA\nreturn\nendIf\nnA=nFew[5]",
        "if bA and size(nFew)>5 and nFew[5]==1\nendIf",
        "if size(nFew)<=5 or nFew[5]==1\nendIf",
        "while size(nFew)>nA\nnA=nFew[5]\nendWhile",
        "for nA=6 to size(nFew)-1\nnFew[5]=nFew[nA]\nendFor",
        "for nA=0 to size(nFew)-1\nif nA==5\nnFew[5]=1\nendIf\nendFor",
        "switch size(nFew)\ncase 6\nnFew[5]=1\nbreak\nendSwitch",
        "switch size(nFew)\ncase 3\nbreak\ndefault\nnFew[5]=1\nbreak\nendSwitch",
        "if isDefined(nFew[5])\nnA=nFew[5]\nendIf",
        "if size(nGrid,1)>2\nnA=nGrid[2,0]\nendIf",
        "if size(l_n)>2\nnA=l_n[2]\nendIf",
        "nLast=size(nFew)-1\nnA=nLast\nif nA>=5\nnA=nFew[5]\nendIf",
        "bA=isDefined(nFew[5])\nif bA\nnA=nFew[5]\nendIf",
        "if false\nnA=nFew[5]+nFew[-1]\nendIf",
        "if false and nFew[5]==1\nendIf",
        "return\nnA=nFew[5]",
    ] {
        assert_eq!(index_faults(code), 0, "{code}");
    }
}

#[test]
fn an_index_after_another_condition_is_a_fault() {
    for code in [
        "nA=nFew[5]",
        "if bA\nnA=nFew[5]\nendIf",
        "if nFew[0]>1 and abs(nFew[1])>2\nnA=nFew[5]\nendIf",
        "if size(nFew)>2\nnA=nFew[5]\nendIf",
        "if size(nFew)>2 and nFew[5]==1\nendIf",
        "if nFew[5]==1 and size(nFew)>5\nendIf",
        "if size(nGrid)>nA\nnA=nFew[5]\nendIf",
        "if size(nFew)>5\nnA=1\nendIf\nnA=nFew[5]",
        "if size(nFew)<=nA\nlogMsg(\"short\")\nendIf\nnA=nFew[5]",
        "if size(nFew)>nA\nnA=nFew[-1]\nendIf",
        "if false\nelse\nnA=nFew[5]\nendIf",
        "while bA\nnA=nFew[5]\nendWhile",
        "do\nnA=nFew[5]\nuntil size(nFew)>nA",
    ] {
        assert_eq!(index_faults(code), 1, "{code}");
    }
}

#[test]
fn constants() {
    let expressions = [
        "1+2*3",
        "(1+2)*3",
        "-4%3",
        "1/0",
        "5%0",
        "1==1.0",
        "2>=3",
        "!true",
        "\"a\"+\"b\"",
        "\"a\"!=\"b\"",
        "true xor true",
        "true and nA==1",
        "nA",
        "-\"a\"",
        "\"a\"<\"b\"",
    ];
    let lines: String = expressions.iter().map(|text| format!("? {text}\n")).collect();
    let workspace = workspace(&format!("num nA\n{lines}"));
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let body = body(db, program(db, main, "start"));
    let constants = body.block.iter().zip(expressions).map(|(stmt, text)| {
        let val3_analysis::body::StmtKind::Print(id) = stmt.kind else { panic!("{stmt:?}") };
        assert!(*body.expr(id) != Expr::Missing, "{text}");
        let shown = match body.constant(id) {
            Some(Constant::Number(number)) => number.to_string(),
            Some(Constant::String(text)) => format!("{text:?}"),
            Some(Constant::Bool(value)) => value.to_string(),
            None => "not constant".to_owned(),
        };
        format!("{text} = {shown}\n")
    });
    expect![[r#"
        1+2*3 = 7
        (1+2)*3 = 9
        -4%3 = -1
        1/0 = not constant
        5%0 = not constant
        1==1.0 = true
        2>=3 = false
        !true = false
        "a"+"b" = "ab"
        "a"!="b" = true
        true xor true = false
        true and nA==1 = not constant
        nA = not constant
        -"a" = not constant
        "a"<"b" = not constant
    "#]]
    .assert_eq(&constants.collect::<String>());
}
