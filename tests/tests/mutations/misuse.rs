//! Slips that the controller accepts: misuse of instructions, tasks and values that the manual warns of.

use crate::mutation::{Mutation, slip};

pub(crate) const ARGUMENTS: &[Mutation] = &[
    slip("line behind the last one", "palletiser/watchTasks.pgx", "gotoxy(0,12)", "gotoxy(0,14)", "V0226"),
    slip("wait of a negative time", "palletiser/supervisor.pgx", "delay(0.2)", "delay(-0.2)", "V0226"),
    slip("text of a negative length", "palletiser/onOrder.pgx", "left(x_sLine,l_nAt)", "left(x_sLine,-1)", "V0225"),
    slip(
        "time limit that is over at once",
        "palletiser/pick.pgx",
        "watch(bPartReady==true,10)",
        "watch(bPartReady==true,-10)",
        "V0226",
    ),
    slip("format of another language", "palletiser/drawScreen.pgx", "toString(\".1\"", "toString(\"%.1f\"", "V0227"),
    slip("unknown key of a date", "palletiser/report.pgx", "\"%H:%M:%S \"", "\"%h:%M:%S \"", "V0228"),
    slip("date without keys", "palletiser/report.pgx", "\"%H:%M:%S \"", "\"HH:MM:SS \"", "V0228"),
    slip(
        "misspelt parameter of a line",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  sioCtrl(io:siHost,\"timeOuts\",2)$0\n",
        "V0229",
    ),
    slip(
        "text for the port of a socket",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  sioCtrl(io:siHost,\"port\",\"8000\")$0\n",
        "V0229",
    ),
    slip("division by nothing", "palletiser/place.pgx", "part:nHeight/2", "part:nHeight/0", "V0230"),
    slip(
        "negative blending distance",
        "palletiser/place.pgx",
        "l_mNear.leave=part:nHeight/2",
        "l_mNear.leave=-1",
        "V0231",
    ),
    slip("whole array for one value", "palletiser/start.pgx", "host(0.5)", "host(nTimes)", "V0234"),
    slip(
        "dimension that no array has",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  resize(pCorner,4,1)$0\n",
        "V0225",
    ),
    slip("wait in milliseconds", "palletiser/supervisor.pgx", "delay(0.2)", "delay(200)", "V0240"),
    slip(
        "too few numbers to send",
        "partBag/offset.pgx",
        "  // The lower layers give way",
        "  toBinary(nSink,3,\"4l\",nSink)$0\n  // The lower layers give way",
        "V0241",
    ),
];

pub(crate) const VALUES: &[Mutation] = &[
    slip(
        "move id at an exact number",
        "palletiser/home.pgx",
        "    waitEndMove()\n",
        "    wait(getMoveId()==2)\n",
        "V0232",
    ),
    slip("a computed number that is exact", "palletiser/place.pgx", "if x_bOk==true", "if cos(x_nRow)==0", "V0233"),
    slip("variable assigned to itself", "palletiser/onOrder.pgx", "sWanted=l_sValue", "sWanted=sWanted", "V0237"),
    slip(
        "field assigned to itself",
        "palletiser/clearPallet.pgx",
        "].nWeight=0",
        "].nWeight=tSlots[l_nRow,l_nColumn].nWeight",
        "V0237",
    ),
    slip(
        "variable compared with itself",
        "palletiser/production.pgx",
        "if sWanted!=sLoaded",
        "if sWanted!=sWanted",
        "V0238",
    ),
    slip(
        "the same condition twice",
        "palletiser/layerFull.pgx",
        "io:diNewPallet==true and bRun==true",
        "bRun==true and bRun==true",
        "V0238",
    ),
    slip(
        "result of libDelete dropped",
        "palletiser/stop.pgx",
        "  resetMotion()\n",
        "  resetMotion()\n  libDelete(\"old\")$0\n",
        "V0236",
    ),
    slip(
        "frame that nobody checks",
        "palletiser/init.pgx",
        "if setFrame(pCorner[0],pCorner[1],pCorner[2],fPallet)!=0\n    popUpMsg(\"The corners of the pallet are too close to each other\")\n  endIf",
        "setFrame(pCorner[0],pCorner[1],pCorner[2],fPallet)",
        "V0236",
    ),
    slip(
        "append to an array of two dimensions",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  append(tSlots)$0\n",
        "V0235",
    ),
];

pub(crate) const DATA: &[Mutation] = &[
    slip("negative speed in the data", "palletiser/palletiser.dtx", "vel=\"90\" leave", "vel=\"-90\" leave", "V0242"),
    slip(
        "negative blending in the data",
        "palletiser/palletiser.dtx",
        "leave=\"120\" reach=\"120\"",
        "leave=\"120\" reach=\"-120\"",
        "V0242",
    ),
];

pub(crate) const TASKS: &[Mutation] = &[
    slip("priority of no task", "palletiser/start.pgx", "\"supervisor\",10,", "\"supervisor\",0,", "V0322"),
    slip("priority above 100", "palletiser/start.pgx", "\"production\",50,", "\"production\",500,", "V0322"),
    slip("period of nothing", "palletiser/start.pgx", "0.02,bOverrun", "0,bOverrun", "V0322"),
    slip("period in milliseconds", "palletiser/start.pgx", "0.02,bOverrun", "20,bOverrun", "V0323"),
    slip("period between two steps", "palletiser/start.pgx", "0.02,bOverrun", "0.01,bOverrun", "V0323"),
    slip(
        "third period",
        "palletiser/start.pgx",
        "  taskCreate \"host\",10,host(0.5)",
        "  taskCreateSync \"fast\",0.004,bOverrun,tower(\"\")\n  taskCreateSync \"slow\",0.04,bOverrun,tower(\"\")$0\n  \
         taskCreate \"host\",10,host(0.5)",
        "V0324",
    ),
    slip(
        "task without a name",
        "palletiser/start.pgx",
        "  taskCreate \"host\"",
        "  taskCreate \"\",10,tower(\"\")$0\n  taskCreate \"host\"",
        "V0325",
    ),
    slip(
        "blank in the name of a task",
        "palletiser/start.pgx",
        "  taskCreate \"host\"",
        "  taskCreate \"dark tower\",10,tower(\"\")$0\n  taskCreate \"host\"",
        "V0325",
    ),
    slip(
        "local variable for a task",
        "palletiser/cycle.pgx",
        "  l_nStart=clock()\n",
        "  l_nStart=clock()\n  taskCreate \"mean\",10,average(nTimes,l_nStart)$0\n",
        "V0320",
    ),
    slip(
        "local overrun variable",
        "palletiser/production.pgx",
        "  nState=3\n",
        "  nState=3\n  taskCreateSync \"late\",0.02,l_bOk,sensors()$0\n",
        "V0321",
    ),
    slip(
        "mutex of one call",
        "palletiser/production.pgx",
        "  nState=3\n",
        "  nState=3\n  setMutex(l_bOk)$0\n",
        "V0327",
    ),
    slip(
        "latch read at once",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  setLatch(io:diPart)\n  wait(getLatch(jHome))$0\n",
        "V0326",
    ),
    slip(
        "key of another time",
        "palletiser/home.pgx",
        "    return\n",
        "    wait(getKey()!=-1)$0\n    return\n",
        "V0328",
    ),
    slip(
        "condition with nothing to do",
        "palletiser/layerFull.pgx",
        "  call clearPallet()",
        "  if nState==3$0\n  endIf\n  call clearPallet()",
        "V0330",
    ),
];
