//! Slips in the order of lines and in moves.

use crate::mutations::mutation::{Mutation, slip};

pub(crate) const ORDER: &[Mutation] = &[
    slip(
        "call behind return",
        "palletiser/cycle.pgx",
        "    call layerFull(x_bOk)\n    return\n",
        "    return\n    call layerFull(x_bOk)$0\n",
        "V0302",
    ),
    slip(
        "line behind an endless loop",
        "palletiser/supervisor.pgx",
        "    delay(0.2)\n  endWhile\n",
        "    delay(0.2)\n  endWhile\n  cls()$0\n",
        "V0302",
    ),
    slip(
        "return left in",
        "palletiser/init.pgx",
        "  call clearPallet()\n",
        "  return\n  call clearPallet()$0\n",
        "V0302",
    ),
    slip("for without step -1", "palletiser/average.pgx", "l_i=0 to size(x_nTimes)-1", "l_i=9 to 0", "V0303"),
    slip("loop switched off", "palletiser/host.pgx", "while true", "while false", "V0303"),
    slip("step 0", "palletiser/nextSlot.pgx", "to 0 step -1", "to 0 step 0", "V0304"),
    slip(
        "counter counted twice",
        "palletiser/average.pgx",
        "l_nSum=l_nSum+x_nTimes[l_i]\n",
        "l_nSum=l_nSum+x_nTimes[l_i]\n    l_i=l_i+1$0\n",
        "V0305",
    ),
    slip(
        "one counter for two loops",
        "palletiser/average.pgx",
        "    l_nSum=l_nSum+x_nTimes[l_i]\n",
        "    for l_i=0 to 1$0\n      l_nSum=l_nSum+x_nTimes[l_i]\n    endFor\n",
        "V0315",
    ),
    slip("key twice in a switch", "palletiser/onKey.pgx", "case 272,278", "case 271,278", "V0306"),
    slip(
        "name twice in a switch",
        "palletiser/loadPart.pgx",
        "case \"partBag\",\"sack\"",
        "case \"partBag\",\"partBox\"",
        "V0306",
    ),
    slip(
        "condition copied",
        "palletiser/watchTasks.pgx",
        "elseIf l_nStatus==-1 and bRun==true",
        "elseIf l_nStatus==1",
        "V0307",
    ),
    slip(
        "narrow range behind a wide one",
        "palletiser/watchTasks.pgx",
        "elseIf l_nStatus==1\n",
        "elseIf l_nStatus>=60\n",
        "V0307",
    ),
    slip(
        "value stored twice",
        "palletiser/cycle.pgx",
        "  l_nStart=clock()\n",
        "  l_nStart=clock()\n  l_nStart=clock()\n",
        "V0312",
    ),
];

pub(crate) const WAITING: &[Mutation] = &[
    slip("lost delay of a synchronous task", "palletiser/sensors.pgx", "    delay(0)\n", "", "V0308")
        .at(&[("palletiser/sensors.pgx", "while true")]),
    slip(
        "empty loop for wait",
        "palletiser/layerFull.pgx",
        "    wait(io:diNewPallet==true and bRun==true)\n",
        "    while io:diNewPallet==false or bRun==false\n    endWhile\n",
        "V0309",
    ),
    slip(
        "empty do for wait",
        "palletiser/production.pgx",
        "    wait(bRun==true)\n",
        "    do\n    until bRun==true$0\n",
        "V0309",
    ),
    slip(
        "program that calls itself",
        "palletiser/home.pgx",
        "call report(\"home position out of range\")",
        "call home(x_bOk)",
        "V0310",
    ),
    slip(
        "programs that call each other",
        "palletiser/clearPallet.pgx",
        "  dioSet(io:doLayer,nLayer)\n",
        "  dioSet(io:doLayer,nLayer)\n  call init()$0\n",
        "V0310",
    ),
];

pub(crate) const POSITIONS: &[Mutation] = &[
    slip(
        "two sides that exclude each other",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  if nLayer<0 and nLayer>3$0\n    nState=1\n  endIf\n",
        "V0317",
    ),
    slip(
        "branches that are the same",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  if bVacuumLost==true$0\n    nState=1\n  else\n    nState=1\n  endIf\n",
        "V0318",
    ),
    slip(
        "counter that is not advanced",
        "palletiser/cycle.pgx",
        "  l_nStart=clock()\n",
        "  l_nStart=clock()\n  l_i=0\n  while l_i<5$0\n    delay(1)\n  endWhile\n",
        "V0319",
    ),
    slip(
        "return while a mutex is taken",
        "palletiser/cycle.pgx",
        "  if l_bFree==false\n",
        "  setMutex(bScreen)\n  if l_bFree==true\n    return$0\n  endIf\n  bScreen=false\n  if l_bFree==false\n",
        "V0332",
    ),
    slip(
        "loop over the end of an array",
        "palletiser/cycle.pgx",
        "  l_nStart=clock()\n",
        "  l_nStart=clock()\n  for l_i=0 to size(nTimes)\n    nTimes[l_i]=0$0\n  endFor\n",
        "V0333",
    ),
    slip(
        "move that the next line discards",
        "palletiser/pick.pgx",
        "    waitEndMove()\n",
        "    resetMotion()\n",
        "V0417",
    )
    .at(&[("palletiser/pick.pgx", "movel(pPick")]),
    slip(
        "circle with one point twice",
        "palletiser/pick.pgx",
        "movel(pPick,tSuction,mSlow)",
        "movec(pPick,pPick,tSuction,mSlow)",
        "V0418",
    ),
    slip("joint used before it is set", "palletiser/home.pgx", "  l_jAway=abs(herej()-jHome)\n", "", "V0311"),
    slip(
        "lost call that sets a position",
        "palletiser/place.pgx",
        "  call part:offset(nLayer,x_nRow,x_nColumn,l_trOffset)\n  // The part turns about its own axis and is raised in the pallet\n",
        "",
        "V0311",
    ),
    slip(
        "position without a frame",
        "palletiser/pick.pgx",
        "    l_pNear=appro(pPick,{0,0,-nAbove,0,0,0})\n    movej(l_pNear,",
        "    l_pNear.trsf.z=nAbove\n    movej($0l_pNear,",
        "V0401",
    ),
    slip("lost position of the arm", "palletiser/home.pgx", "    l_pUp=here(tSuction,fCell)\n", "", "V0401")
        .at(&[("palletiser/home.pgx", "movel(l_pUp")]),
    slip(
        "input that is linked to nothing",
        "palletiser/home.pgx",
        "    </Locals>\n    <Code><![CDATA[begin\n",
        "      <Local name=\"l_diKey\" type=\"dio\" xsi:type=\"array\" size=\"1\" />\n    </Locals>\n    \
         <Code><![CDATA[begin\n  wait(l_diKey==true)$0\n",
        "V0316",
    ),
    slip(
        "lost father",
        "palletiser/palletiser.dtx",
        "z=\"950\" rx=\"180\" shoulder=\"lefty\" elbow=\"epositive\" wrist=\"wpositive\" fatherId=\"fCell[0]\"",
        "z=\"950\" rx=\"180\" shoulder=\"lefty\" elbow=\"epositive\" wrist=\"wpositive\"",
        "V0402",
    )
    .at(&[("palletiser/place.pgx", "movej(pSafe")]),
    slip(
        "other elbow in front of a line",
        "palletiser/pick.pgx",
        "    movej(l_pNear,tSuction,mFast)\n    movel(pPick,",
        "    l_pNear.config.elbow=enegative\n    movej(l_pNear,tSuction,mFast)\n    movel($0pPick,",
        "V0405",
    ),
];

pub(crate) const MOVES: &[Mutation] = &[
    slip(
        "gripper behind a rounded corner",
        "palletiser/pick.pgx",
        "movel(pPick,tSuction,mSlow)\n    waitEndMove()\n",
        "movel(pPick,tSuction,mFast)\n    close($0tSuction)\n",
        "V0403",
    ),
    slip(
        "compliant move behind a rounded corner",
        "palletiser/pick.pgx",
        "movel(pPick,tSuction,mSlow)",
        "movelf(pPick,tSuction,mSlow,20)",
        "V0404",
    ),
    slip(
        "output before the wait",
        "palletiser/pick.pgx",
        "movel(pPick,tSuction,mSlow)\n    waitEndMove()\n",
        "movel(pPick,tSuction,mSlow)\n    io:doClamp=true$0\n    waitEndMove()\n",
        "V0406",
    ),
    slip(
        "stopped and not set free",
        "palletiser/home.pgx",
        "    movel(l_pUp,",
        "    stopMove()\n    movel($0l_pUp,",
        "V0407",
    ),
    slip(
        "position asked on the way",
        "palletiser/home.pgx",
        "    movej(jHome,tSuction,mFast)\n",
        "    movej(jHome,tSuction,mFast)\n    x_bOk=distance(here(tSuction,fCell),pSafe)<1$0\n",
        "V0408",
    ),
];
