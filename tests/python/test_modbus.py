"""Tests of `val3 run --modbus` with the clients of pymodbus."""

import asyncio
import json
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import val3

from pymodbus.client import AsyncModbusTcpClient

CLIENTS = 10

#: Bits 0 to 8 and words 0 to 7 are written by clients, the others by the robot.
TABLES = f"""<?xml version="1.0" encoding="ISO-8859-1" standalone="yes"?>
<TOPICSLIST>
  <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" RefreshPeriod="200" Actif="1">
    <MODULE Tag_name_root="Bit" IDModule="BOOLEAN" InputSize="" OutputSize="18">
      <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
      <ITEM Name="bIn" Syntaxe="%Q1:8" Offset="1"/>
      <ITEM Name="bReady" Syntaxe="%I9" Offset="9"/>
      <ITEM Name="bOut" Syntaxe="%I10:8" Offset="10"/>
    </MODULE>
    <MODULE Tag_name_root="Word" IDModule="WORD" InputSize="" OutputSize="256">
      <ITEM Name="nIn" Syntaxe="%QW0:8" Offset="0"/>
      <ITEM Name="nOut" Syntaxe="%IW8:8" Offset="8"/>
    </MODULE>
  </TOPIC>
  <GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502" ConnectionNumber="{CLIENTS}"/>
</TOPICSLIST>
"""

#: Copies bits and words; word 2 is negated, and the words 4 and 5 are a number with 32 bits that is doubled.
PROGRAM = """<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="start">
    <Code><![CDATA[begin
  while true
    doReady=(diStart==true)
    for nItem=0 to 7
      doOut[nItem]=(diIn[nItem]==true)
    endFor
    for nItem=0 to 7
      aioSet(aoOut[nItem],aioGet(aiIn[nItem]))
    endFor
    aioSet(aoOut[2],-aioGet(aiIn[2]))
    nWords[0]=aioGet(aiIn[4])
    nWords[1]=aioGet(aiIn[5])
    toBinary(nWords,2,"2b",nBytes)
    fromBinary(nBytes,4,"4.0b",nReal)
    nReal[0]=2*nReal[0]
    toBinary(nReal,1,"4.0b",nBytes)
    fromBinary(nBytes,4,"2b",nWords)
    aioSet(aoOut[4],nWords[0])
    aioSet(aoOut[5],nWords[1])
    delay(0.004)
  endWhile
end]]></Code>
  </Program>
</Programs>
"""

STOP = """<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="stop"><Code><![CDATA[begin
end]]></Code></Program>
</Programs>
"""

PROJECT = """<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
  <Programs><Program file="start.pgx" /><Program file="stop.pgx" /></Programs>
  <Database><Data file="main.dtx" /></Database>
  <Libraries />
  <Types />
</Project>
"""


def datum(name: str, kind: str, links: list[str], size: int = 1) -> str:
    """Return a data item, linked to these items of the server."""
    values = [f'<Value key="{key}" link="ModbusSrv-0\\{link}" />' for key, link in enumerate(links)]
    size = len(links) or size
    return f'<Data name="{name}" access="private" xsi:type="array" type="{kind}" size="{size}">{"".join(values)}</Data>'


def elements(item: str) -> list[str]:
    """Return the links to the elements of an array of eight."""
    return [f"{item}[{index}]" for index in range(8)]


DATA = "\n".join([
    '<?xml version="1.0" encoding="utf-8"?>',
    '<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">',
    "<Datas>",
    datum("aiIn", "aio", elements("Modbus-Word\\nIn")),
    datum("aoOut", "aio", elements("Modbus-Word\\nOut")),
    datum("diIn", "dio", elements("Modbus-Bit\\bIn")),
    datum("diStart", "dio", ["Modbus-Bit\\bStart"]),
    datum("doOut", "dio", elements("Modbus-Bit\\bOut")),
    datum("doReady", "dio", ["Modbus-Bit\\bReady"]),
    datum("nBytes", "num", [], size=4),
    datum("nItem", "num", []),
    datum("nReal", "num", [], size=2),
    datum("nWords", "num", [], size=2),
    "</Datas>",
    "</Database>",
])  # fmt: skip


def write_cell(folder: Path) -> Path:
    """Write the cell. Return the folder of the application."""
    application = folder / "usr" / "usrapp" / "main"
    tables = folder / "usr" / "applicom" / "Modbus"
    for path in (application, tables):
        path.mkdir(parents=True)
    (tables / "modbus.xml").write_text(TABLES, encoding="latin-1")
    for name, text in (("main.pjx", PROJECT), ("main.dtx", DATA), ("start.pgx", PROGRAM), ("stop.pgx", STOP)):
        (application / name).write_text(text, encoding="utf-8")
    return application


class Served:
    """A run that is served."""

    def __init__(self, application: Path, port: int) -> None:
        self.application = application
        self.port = port

    @asynccontextmanager
    async def client(self) -> AsyncIterator[AsyncModbusTcpClient]:
        """Connect a client."""
        client = AsyncModbusTcpClient("127.0.0.1", port=self.port, timeout=10, retries=0)
        assert await client.connect()
        try:
            yield client
        finally:
            client.close()


@asynccontextmanager
async def served(*arguments: str) -> AsyncIterator[Served]:
    """Run the application, and end it with the block."""
    with tempfile.TemporaryDirectory() as folder:
        application = write_cell(Path(folder))
        command = [val3.find_binary(), "run", str(application), "--modbus", "127.0.0.1:0", *arguments]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            assert process.stderr is not None
            seen = ""
            port = None
            while port is None:
                line = process.stderr.readline()
                assert line, f"the run ended: {seen}"
                seen += line
                port = re.search(r"the Modbus server of `Modbus` is at 127\.0\.0\.1:(\d+)", line)
            try:
                yield Served(application, int(port[1]))
            finally:
                process.terminate()
                process.communicate(timeout=60)


async def words(client: AsyncModbusTcpClient, address: int, count: int = 1) -> list[int]:
    """Read words."""
    response = await client.read_holding_registers(address, count=count, device_id=1)
    assert not response.isError(), response
    return list(response.registers)


async def until(client: AsyncModbusTcpClient, address: int, expected: list[int]) -> None:
    """Read words until they have these values."""
    end = time.monotonic() + 30
    while (found := await words(client, address, len(expected))) != expected:
        assert time.monotonic() < end, f"{found} instead of {expected}"
        await asyncio.sleep(0.004)


class ModbusTest(unittest.IsolatedAsyncioTestCase):
    """The server of a cell with an application that copies its inputs."""

    async def test_bits_words_and_reals(self) -> None:
        async with served() as run, run.client() as client:
            self.assertFalse((await client.write_coil(0, True, device_id=1)).isError())
            pattern = [True, False, True, True, False, False, True, False]
            self.assertFalse((await client.write_coils(1, pattern, device_id=255)).isError())
            self.assertFalse((await client.write_registers(0, [7, 65535, 5], device_id=0)).isError())
            self.assertFalse((await client.write_register(3, 40000, device_id=1)).isError())
            kind = client.DATATYPE.FLOAT32
            real = client.convert_to_registers(-1234.5, kind)
            self.assertFalse((await client.write_registers(4, real, device_id=1)).isError())
            await until(client, 8, [7, 65535, 65536 - 5, 40000, *client.convert_to_registers(-2469.0, kind)])
            self.assertEqual(client.convert_from_registers(await words(client, 12, 2), kind), -2469.0)
            for read in (client.read_coils, client.read_discrete_inputs):
                response = await read(0, count=18, device_id=1)
                self.assertEqual(response.bits[:18], [True, *pattern, True, *pattern])
            response = await client.read_input_registers(0, count=4, device_id=1)
            self.assertEqual(response.registers, [7, 65535, 5, 40000])
            masked = await client.mask_write_register(address=2, and_mask=0xFFFD, or_mask=0x000A, device_id=1)
            self.assertFalse(masked.isError())
            response = await client.readwrite_registers(
                read_address=0, read_count=4, write_address=1, values=[9], device_id=1
            )
            self.assertEqual(response.registers, [7, 9, 7, 40000])
            await until(client, 8, [7, 9, 65536 - 7, 40000])

    async def test_wrong_requests_are_exceptions(self) -> None:
        async with served() as run, run.client() as client:
            for response, code in [
                (await client.read_coils(18, count=1, device_id=1), 2),
                (await client.read_coils(17, count=2, device_id=1), 2),
                (await client.read_holding_registers(5000, count=1, device_id=1), 2),
                (await client.write_registers(15, [1, 2], device_id=1), 2),
                (await client.write_coil(65535, True, device_id=1), 2),
                (await client.mask_write_register(address=5000, and_mask=1, or_mask=2, device_id=1), 2),
                (await client.read_fifo_queue(address=0, device_id=1), 1),
                (await client.read_device_information(device_id=1), 1),
            ]:
                self.assertEqual((response.isError(), response.exception_code), (True, code), response)
            # The values of the robot cannot be written, and a block may contain them.
            self.assertFalse((await client.write_registers(6, [1, 2, 3, 4], device_id=1)).isError())
            await until(client, 6, [1, 2, 0, 0])
            await until(client, 14, [1, 2])

    async def test_ten_clients_exchange_values(self) -> None:
        async with served() as run:

            async def exchange(number: int) -> None:
                async with run.client() as client:
                    for value in range(1, 200):
                        address = number % 8
                        response = await client.write_register(address, 100 * number + value, device_id=1)
                        assert not response.isError()
                        assert len(await words(client, 0, 16)) == 16

            await asyncio.gather(*(exchange(number) for number in range(CLIENTS)))
            async with run.client() as client:
                await until(client, 8, (await words(client, 0, 2)))

    async def test_a_further_client_is_rejected(self) -> None:
        async with served() as run:
            clients = [AsyncModbusTcpClient("127.0.0.1", port=run.port, timeout=10) for _ in range(CLIENTS)]
            for client in clients:
                self.assertTrue(await client.connect())
                await words(client, 0)
            reader, writer = await asyncio.open_connection("127.0.0.1", run.port)
            self.assertEqual(await asyncio.wait_for(reader.read(), 10), b"")
            writer.close()
            await words(clients[0], 0)
            for client in clients:
                client.close()

    async def test_a_cycle_of_ten_milliseconds(self) -> None:
        async with served() as run, run.client() as client:
            await cycles(client, 3)

    async def test_a_recorded_run_is_a_scenario(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            events = Path(folder) / "run.jsonl"
            async with served("--events", str(events)) as run, run.client() as client:
                await client.write_coil(0, True, device_id=1)
                await client.write_register(1, 77, device_id=1)
                await until(client, 9, [77])
                kept = Path(folder) / "cell"
                shutil.copytree(run.application.parents[1], kept)
            recorded = [json.loads(line) for line in events.read_text(encoding="utf-8").splitlines()]
            acts = [event["keys"]["io"] for event in recorded if event["kind"] == "act"]
            merged = {link: value for act in acts for link, value in act.items()}
            start, word = "ModbusSrv-0\\Modbus-Bit\\bStart", "ModbusSrv-0\\Modbus-Word\\nIn[1]"
            self.assertEqual(merged, {start: True, word: 77.0})
            scenario = kept / "usrapp" / "tests" / "plc.toml"
            scenario.parent.mkdir(exist_ok=True)
            application = kept / "usrapp" / "main"
            record = [val3.find_binary(), "test", str(application), "--record", str(events), "--to", str(scenario)]
            done = subprocess.run(record, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("bStart", scenario.read_text(encoding="utf-8"))
            report = val3.test(kept / "usrapp")
            self.assertEqual((report.passed, report.failed), (1, 0))


async def cycles(client: AsyncModbusTcpClient, seconds: float) -> tuple[int, list[float], list[int]]:
    """Act as a PLC with a cycle of 10 ms: write eight words, read all, and compare the echo of the counter.

    Return the number of cycles, the duration of each exchange in seconds, and the age of each echo in cycles.
    """
    start = time.monotonic()
    durations, ages = [], []
    number = 0
    while (now := time.monotonic()) - start < seconds:
        number += 1
        response = await client.write_registers(0, [number % 65536] * 2, device_id=1)
        assert not response.isError()
        read = await words(client, 0, 16)
        durations.append(time.monotonic() - now)
        ages.append((number - read[8]) % 65536)
        await asyncio.sleep(max(0.0, start + 0.01 * number - time.monotonic()))
    assert ages[-1] < 100, f"the echo is {ages[-1]} cycles old"
    return number, durations, ages
