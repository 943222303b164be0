using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Opening and saving: what is not saved is not lost without a word, and files are there whole or not at all.</summary>
public sealed class SceneFilesTests : IDisposable
{
    private readonly SessionFolder _folder = new();
    private readonly DocumentSession _session;

    public SceneFilesTests() => _session = new(_folder.User, ShippedScenes.Folder, new FakeTime());

    public static TheoryData<string> Scenes => ShippedScenes.All;

    private SceneDocument Document => _session.Document;

    private SceneFiles Files => _session.Files;

    public void Dispose()
    {
        _session.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task The_scene_to_begin_with_is_good()
    {
        Assert.NotNull((await Document.WhenBuilt()).Load.Scene);
        Assert.Empty(Document.Status.Diagnostics);
        Assert.False(Document.IsDirty);
    }

    [Fact]
    public async Task Opening_that_is_cancelled_brings_the_text_before_it_back_and_waits_for_no_file()
    {
        using ManualResetEventSlim isRead = new();
        using ManualResetEventSlim isReading = new();
        ModelFile.Register(".slowest", _ =>
        {
            isReading.Set();
            isRead.Wait(TimeSpan.FromMinutes(1));
            throw new ModelException("it was read for nobody");
        });
        File.Copy(Path.Combine(ShippedScenes.Folder, "primer/01-sphere.json"), _folder["before.json"]);
        Files.Open(_folder["before.json"]);
        GoodScene before = (await Document.WhenBuilt()).LastGood!;
        _folder.Write("slow.slowest", "without an end");
        _folder.Write("after.json", """{ "shapes": [{ "type": "model", "file": "slow.slowest" }] }""");
        Files.Open(_folder["after.json"]);
        Assert.True(isReading.Wait(TimeSpan.FromMinutes(1)));
        Assert.Equal("slow.slowest", Document.Status.Reading);
        Assert.False(Document.Status.HasPicture);

        Files.CancelOpening();
        GoodScene after = (await Document.WhenBuilt()).LastGood!;
        Assert.Equal((before.Text, "before.json"), (after.Text, Document.Place.Name));
        Assert.NotEqual(before.Document, after.Document);
        Assert.Null(Document.Status.Reading);
        isRead.Set();
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_that_is_opened_and_saved_is_the_same_to_the_byte(string path)
    {
        byte[] bytes = File.ReadAllBytes(Path.Combine(ShippedScenes.Folder, path));
        File.WriteAllBytes(_folder["a.json"], bytes);
        Files.Open(_folder["a.json"]);
        Assert.Equal(_folder["a.json"], Files.Save());
        Assert.Equal(bytes, File.ReadAllBytes(_folder["a.json"]));
        string windows = ShippedScenes.Text(path).ReplaceLineEndings("\r\n");
        _folder.Write("b.json", windows);
        Files.Open(_folder["b.json"]);
        Files.Save();
        Assert.Equal(windows, File.ReadAllText(_folder["b.json"]));
        Assert.Equal([_folder["b.json"], _folder["a.json"]], Files.Recent);
    }

    [Fact]
    public void Changes_are_not_lost_without_a_word()
    {
        string path = _folder.Write("a.json", "{}");
        Document.TryReplace(1, 0, 0, "// mine\n", null);
        string text = Document.Text;
        Action[] openings = [() => Files.New(), () => Files.Open(path), () => Files.OpenGallery("minimal.json")];
        Assert.All(openings, open => Assert.Equal(SessionFault.Unsaved, Assert.Throws<SessionException>(open).Fault));
        Assert.Equal(text, Document.Text);
        Files.Open(path, discard: true);
        Assert.Equal("{}", Document.Text);
    }

    [Fact]
    public void Other_files_are_not_overwritten_unless_asked_for()
    {
        string other = _folder.Write("other.json", "theirs");
        Assert.Equal(SessionFault.Exists, Assert.Throws<SessionException>(() => Files.Save(other)).Fault);
        Assert.Equal("theirs", File.ReadAllText(other));
        Files.Save(other, overwrite: true);
        Assert.Equal(Document.Text, File.ReadAllText(other));
        Document.TryReplace(Document.Revision, 0, 0, " ", null);
        Files.Save();
        File.WriteAllText(other, "theirs again");
        Assert.Equal(SessionFault.ChangedOnDisk, Assert.Throws<SessionException>(() => Files.Save()).Fault);
        Assert.Equal("theirs again", File.ReadAllText(other));
    }

    [Theory]
    [InlineData("relative.json")]
    [InlineData("/nowhere/at/all/a.json")]
    [InlineData("/tmp/a.obj")]
    [InlineData("/tmp/\0.json")]
    public void Places_where_nothing_can_be_saved_are_refused(string path) => Assert.Throws<SessionException>(() => Files.Save(path));

    [SkippableFact]
    public void A_folder_that_cannot_be_written_to_is_a_sentence_and_leaves_nothing()
    {
        Skip.If(OperatingSystem.IsWindows() || Environment.IsPrivilegedProcess, "everything can be written here");
        Directory.CreateDirectory(_folder["closed"]);
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(_folder["closed"], UnixFileMode.UserRead | UnixFileMode.UserExecute);
        }

        Assert.Contains("denied", Assert.Throws<SessionException>(() => Files.Save(_folder["closed/a.json"])).Message, StringComparison.Ordinal);
        Assert.Empty(Directory.GetFileSystemEntries(_folder["closed"]));
        Assert.Null(Document.Place.Path);
    }

    [Fact]
    public async Task A_scene_saved_into_another_folder_still_finds_its_files()
    {
        Files.OpenGallery("report/scene1.json");
        Assert.Null(Document.Place.Path);
        Assert.NotNull((await Document.WhenBuilt()).Load.Scene);
        Directory.CreateDirectory(_folder["deep/er"]);
        Files.Save(_folder["deep/er/mine"]);
        Assert.Equal(_folder["deep/er/mine.json"], Document.Place.Path);
        Assert.NotNull((await Document.WhenBuilt()).Load.Scene);
        Assert.NotNull(SceneLoader.Load(_folder["deep/er/mine.json"]).Scene);
        Assert.False(Document.IsDirty);
        Assert.Contains("raytracer.schema.json", JsonText.Of(Document.Text).At("/$schema").Text, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Models_open_as_scenes_with_camera_and_light_written_out()
    {
        string model = _folder.Write("thing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.Open(model);
        DocumentContent content = await Document.WhenBuilt();
        Assert.NotNull(content.Load.Scene);
        Assert.Equal(("thing.json", null), (Document.Place.Name, Document.Place.Path));
        JsonText text = JsonText.Of(Document.Text);
        Assert.Equal("thing.obj", text.At("/shapes/0/file").Text);
        Assert.NotNull(text.At("/camera/position"));
        Assert.Single(text.At("/lights").Items);
    }

    [Fact]
    public void Files_that_are_none_are_refused_and_the_document_stays()
    {
        string text = Document.Text;
        File.WriteAllBytes(_folder["utf16.json"], [0xFF, 0xFE, 0x7B, 0]);
        string broken = _folder.Write("broken.obj", "f 1 2 3\n");
        string zip = _folder.Write("broken.zip", "PK no");
        foreach (string path in new[] { _folder["utf16.json"], _folder["missing.json"], broken, zip, _folder.FullName, "", "a.json" })
        {
            Assert.Throws<SessionException>(() => Files.Open(path));
        }

        Assert.Equal(text, Document.Text);
    }

    [Fact]
    public void A_text_that_is_no_json_is_opened_and_reported()
    {
        Files.Open(_folder.Write("a.json", "{ not json"));
        Assert.Equal("{ not json", Document.Text);
    }

    [Fact]
    public async Task Dropped_files_are_kept_opened_and_bounded()
    {
        (string picture, bool opened) = await Files.Upload("globe.png", new MemoryStream([1, 2, 3]));
        Assert.False(opened);
        Assert.Equal([1, 2, 3], await File.ReadAllBytesAsync(picture));
        (string scene, opened) = await Files.Upload("folder\\..\\my scene.json", new MemoryStream("{}"u8.ToArray()));
        Assert.True(opened);
        Assert.Equal(("my scene.json", null), (Document.Place.Name, Document.Place.Path));
        Assert.Equal(Path.GetDirectoryName(picture), Path.GetDirectoryName(scene));
        Assert.StartsWith(_folder.User.Uploads, scene, StringComparison.Ordinal);
        foreach (string name in new[] { "", "..", "a/..", ".hidden.json", "a\nb.json", new string('x', 300) })
        {
            await Assert.ThrowsAsync<SessionException>(() => Files.Upload(name, new MemoryStream([1])));
        }

        await Assert.ThrowsAsync<SessionException>(() => Files.Upload("large.png", new EndlessStream()));
        Assert.Equal(2, Directory.GetFiles(Path.GetDirectoryName(scene)!).Length);
    }

    [Fact]
    public void What_is_not_shown_of_a_scene_of_Mitsuba_is_reported_at_the_head_of_its_text()
    {
        _folder.Write("a.xml", "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/></sensor><sensor type=\"perspective\"/><shape type=\"sphere\"/></scene>");
        Files.Open(_folder["a.xml"]);
        Assert.StartsWith("// a.xml:1:", Document.Text, StringComparison.Ordinal);
        Assert.NotNull(Document.Read.Description);
        Assert.Equal("a.json", Document.Place.Name);
    }

    [Fact]
    public void A_folder_is_listed_with_what_can_be_opened_and_no_more()
    {
        _folder.Write("list/b.json", "{}");
        _folder.Write("list/a.OBJ", "");
        _folder.Write("list/c.txt", "");
        _folder.Write("list/.hidden.json", "");
        _folder.Write("list/sub/x.json", "");
        FolderListing listing = Files.List(_folder["list"]);
        Assert.Equal(["a.OBJ", "b.json"], listing.Files.Select(f => f.Name));
        _folder.Write("list/d.png", "");
        _folder.Write("list/e.vol", "");
        Assert.Equal(["a.OBJ", "d.png", "e.vol"], Files.List(_folder["list"], isNamed: true).Files.Select(f => f.Name));
        Assert.Equal(["sub"], listing.Folders);
        Assert.Equal(_folder.FullName, listing.Parent);
        Assert.Equal(_folder.FullName, Files.List().Path);
        Assert.Throws<SessionException>(() => Files.List(_folder["nowhere"]));
        Assert.Throws<SessionException>(() => Files.List("list"));
    }

    private sealed class EndlessStream : MemoryStream
    {
        public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) => ValueTask.FromResult(buffer.Length);
    }
}
