using System.IO.Compression;
using System.Text;

namespace RayTracer.Labs.Tests;

/// <summary>Hand-ins are files of others: whatever is in them, C# alone is taken, within a budget.</summary>
public sealed class HandInTests : IDisposable
{
    private const int Mutants = 5000;
    private const string Card = """{ "Lab": 1, "Name": "Ada", "Version": "0.1.0" }""";
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Sources_come_back_and_nothing_else()
    {
        LabFolder folder = Worked();
        string zip = HandIn.Write(folder);
        Assert.Equal("lab1-ada-lovelace.zip", Path.GetFileName(zip));
        (LabFolder unpacked, bool isAsHandedIn) = HandIn.Unpack(zip, Target());
        Assert.True(isAsHandedIn);
        Assert.Equal(("Ada Lovelace", 1), (unpacked.Card.Name, unpacked.Card.Lab));
        Assert.Equal(["Mine.cs", "Mine.cs"], unpacked.Sources.Select(Path.GetFileName));
        Assert.Equal(2, Directory.GetFiles(unpacked.Path, "*", SearchOption.AllDirectories).Length);
        Assert.Equal(["Mine.cs", "Mine.cs"], HandIn.Unpack(folder.Path, Target()).Folder.Sources.Select(Path.GetFileName));
    }

    [Fact]
    public void A_changed_source_is_noticed()
    {
        string zip = HandIn.Write(Worked());
        using (ZipArchive archive = ZipFile.Open(zip, ZipArchiveMode.Update))
        {
            using StreamWriter more = new(archive.CreateEntry("More.cs").Open());
            more.Write("class More;");
        }

        Assert.False(HandIn.Unpack(zip, Target()).IsAsHandedIn);
    }

    [Fact]
    public void Names_lead_nowhere_and_lengths_are_counted()
    {
        string zip = Zip(("lab.json", Card), ("../../escaped.cs", "a"), ("/etc/absolute.cs", "b"), (@"..\..\back.cs", "c"), ("bin/Made.cs", "d"), ("Lab1.csproj", "<Project />"), ("Directory.Build.targets", "e"));
        string target = Target();
        LabFolder folder = HandIn.Unpack(zip, target).Folder;
        Assert.Equal(["absolute.cs", "back.cs", "escaped.cs"], folder.Sources.Select(s => Path.GetFileName(s)!).Order());
        Assert.All(folder.Sources, s => Assert.StartsWith(target, Path.GetFullPath(s), StringComparison.Ordinal));
        Assert.False(File.Exists(_folder["escaped.cs"]));
        Refused("too large", Zip(("lab.json", Card), ("a.cs", new string('a', 5 << 20))));
        Refused("too large", Zip([("lab.json", Card), .. Enumerable.Range(0, 300).Select(i => ($"{i}.cs", ""))]));
    }

    [Fact]
    public void What_is_no_hand_in_is_refused_with_the_reason()
    {
        File.WriteAllText(_folder["text.zip"], "no zip");
        Refused("is no zip that can be read", _folder["text.zip"]);
        Refused("has no lab.json", Zip(("a.cs", "")));
        Refused("lab.json:2:7: this is not what \"raytracer lab new\" wrote", Zip(("lab.json", "{\n\"Lab\" 1 }"), ("a.cs", "")));
        Refused("there is no lab 77", Zip(("lab.json", """{ "Lab": 77, "Name": "Ada", "Version": "1" }"""), ("a.cs", "")));
        Refused("a \"name\" of 1 to 100 characters in one line", Zip(("lab.json", """{ "Lab": 1, "Name": "a\nb", "Version": "1" }"""), ("a.cs", "")));
    }

    [Fact]
    public void Damaged_hand_ins_are_refused_or_read()
    {
        byte[] zip = File.ReadAllBytes(HandIn.Write(Worked()));
        Random random = new(TestSettings.Seed);
        int read = 0;
        for (int i = 0; i < Mutants; i++)
        {
            byte[] mutant = [.. zip];
            for (int n = random.Next(1, 4); n > 0; n--)
            {
                mutant[random.Next(mutant.Length)] = (byte)random.Next(256);
            }

            mutant = random.Next(10) == 0 ? mutant[..random.Next(mutant.Length)] : mutant;
            try
            {
                HandIn.Read(mutant, "mutant.zip");
                read++;
            }
            catch (LabException)
            {
                // Refused, which is all that may happen.
            }
        }

        Assert.InRange(read, 1, Mutants - 1);
    }

    [Fact]
    public void Tables_hold_any_text()
    {
        LabCard card = new(1, "=cmd()|\"x\", y", "0.1.0");
        Finding right = new("one", 2) { IsRight = true };
        Finding wrong = new("two", 3) { Sentence = "\u0001bad <tag>", Case = "x 1" };
        Mark[] marks = [new("a.zip", new(card, [], [right, wrong]), null), new("b.zip", null, "no zip"), new("c.zip", new(card, ["A.cs:1:2: CS1002"], []), null)];
        string[] rows = MarkTables.Csv(marks).Split("\r\n");
        Assert.Equal("a.zip,\"'=cmd()|\"\"x\"\", y\",1,2,5,two,", rows[1]);
        Assert.Equal("b.zip,,,,,,no zip", rows[2]);
        Assert.EndsWith(",A.cs:1:2: CS1002", rows[3], StringComparison.Ordinal);
        System.Xml.Linq.XElement[] suites = [.. System.Xml.Linq.XDocument.Parse(MarkTables.JUnit(marks)).Root!.Elements()];
        Assert.Equal(["1", "1", "1"], suites.Select(s => s.Attribute("failures")!.Value));
        Assert.Equal(5, System.Text.Json.JsonDocument.Parse(MarkTables.Json(marks)).RootElement[0].GetProperty("most").GetInt32());
    }

    private LabFolder Worked()
    {
        Directory.CreateDirectory(_folder["work/bin"]);
        Directory.CreateDirectory(_folder["work/more"]);
        Directory.CreateDirectory(_folder["work/checks"]);
        File.WriteAllText(_folder["work/lab.json"], Card.Replace("Ada", "Ada Lovelace", StringComparison.Ordinal));
        foreach (string file in new[] { "Mine.cs", "more/Mine.cs", "bin/Made.cs", "checks/Checks.cs", "notes.txt" })
        {
            File.WriteAllText(_folder[$"work/{file}"], file);
        }

        return LabFolder.Open(_folder["work"]);
    }

    private string Target() => Directory.CreateDirectory(_folder[Guid.NewGuid().ToString("N")]).FullName;

    private string Zip(params (string Name, string Text)[] files)
    {
        string path = _folder[$"{Guid.NewGuid():N}.zip"];
        using ZipArchive zip = ZipFile.Open(path, ZipArchiveMode.Create);
        foreach ((string name, string text) in files)
        {
            using Stream stream = zip.CreateEntry(name).Open();
            stream.Write(Encoding.UTF8.GetBytes(text));
        }

        return path;
    }

    private void Refused(string message, string path) =>
        Assert.Contains(message, Assert.Throws<LabException>(() => HandIn.Unpack(path, Target())).Message, StringComparison.Ordinal);
}
