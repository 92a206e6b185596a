//! Run-time errors of inputs and outputs and of references: 122 to 125, 160 to 165 (3.5 to 3.7, 9.3 to 9.6).

use expect_test::expect;

use crate::execution::errors;

#[test]
fn unlinked_inputs_and_outputs_are_errors() {
    errors(
        "dio diFree\naio aiFree\nsio siFree\nnum nBytes[2]",
        &[
            "l_bFlag=diFree",
            "diFree=true",
            "l_nValue=aioGet(aiFree)",
            "l_nValue=aioSet(aiFree,1)",
            "l_nValue=sioGet(siFree,nBytes)",
            "siFree=1",
            "l_nValue=ioStatus(diFree)",
        ],
        expect![[r#"
            123 l_bFlag=diFree
            123 diFree=true
            123 l_nValue=aioGet(aiFree)
            123 l_nValue=aioSet(aiFree,1)
            123 l_nValue=sioGet(siFree,nBytes)
            123 siFree=1
            -1 l_nValue=ioStatus(diFree)
        "#]],
    );
}

#[test]
fn flange_and_world_are_fixed() {
    errors(
        "tool tGrip\nframe fTable",
        &[
            "l_trPart=tGrip.trsf",
            "flange.trsf.z=10\n  l_trPart=position(tGrip,flange)",
            "flange.trsf.z=0\n  l_trPart=position(tGrip,flange)",
            "world.trsf.x=10\n  l_trPart=position(fTable,world)",
        ],
        expect![[r#"
            -1 l_trPart=tGrip.trsf
            160 flange.trsf.z=10; l_trPart=position(tGrip,flange)
            -1 flange.trsf.z=0; l_trPart=position(tGrip,flange)
            161 world.trsf.x=10; l_trPart=position(fTable,world)
        "#]],
    );
}

#[test]
fn missing_references_are_errors() {
    errors(
        "point pFree\nframe fTable\ntool tGrip",
        &[
            "l_trPart=position(pFree,world)",
            "l_trPart=position(l_pPart,world)",
            "l_trPart=position(fTable,world)",
            "l_trPart=position(l_fPart,world)",
            "l_trPart=position(tGrip,flange)",
            "l_trPart=position(l_tPart,flange)",
            "link(l_fPart,world)\n  l_trPart=position(l_fPart,world)",
            "l_fPart=world\n  l_trPart=position(l_fPart,world)",
            "l_tPart=flange\n  l_trPart=position(l_tPart,flange)",
            "link(fTable,l_fPart)",
            "link(tGrip,l_tPart)",
            "link(pFree,l_fPart)",
        ],
        expect![[r#"
            -1 l_trPart=position(pFree,world)
            162 l_trPart=position(l_pPart,world)
            -1 l_trPart=position(fTable,world)
            163 l_trPart=position(l_fPart,world)
            -1 l_trPart=position(tGrip,flange)
            164 l_trPart=position(l_tPart,flange)
            -1 link(l_fPart,world); l_trPart=position(l_fPart,world)
            -1 l_fPart=world; l_trPart=position(l_fPart,world)
            -1 l_tPart=flange; l_trPart=position(l_tPart,flange)
            165 link(fTable,l_fPart)
            165 link(tGrip,l_tPart)
            165 link(pFree,l_fPart)
        "#]],
    );
}
