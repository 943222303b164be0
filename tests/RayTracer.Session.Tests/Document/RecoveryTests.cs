using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>What was not saved is found again after a crash; living sessions keep out of each other's way.</summary>
public sealed class RecoveryTests
{
    [Fact]
    public async Task A_text_is_found_again_after_a_crash_with_its_place()
    {
        using SessionFolder folder = new();
        string path = folder.Write("scenes/a.json", "{\r\n}\r\n");
        FakeTime time = new();
        using DocumentSession first = new(folder.User, ShippedScenes.Folder, time);
        first.Files.Open(path);
        first.Document.TryReplace(first.Document.Revision, 1, 1, "// æ\n", "typing");
        time.Ring();
        using SessionFolder crashed = AfterCrash(folder);

        using DocumentSession second = new(crashed.User, ShippedScenes.Folder, time);
        RecoveryEntry entry = Assert.Single(second.Recovery.Entries);
        Assert.Equal("a.json", entry.Name);
        second.Files.OpenRecovered(entry.Id);
        Assert.Equal(first.Document.Text, second.Document.Text);
        Assert.Equal((path, true), (second.Document.Place.Path, second.Document.IsDirty));
        Assert.Empty(second.Recovery.Entries);

        // The file may have changed since: saving over it must be asked for, and keeps its line ends.
        Assert.Equal(SessionFault.ChangedOnDisk, Assert.Throws<SessionException>(() => second.Files.Save()).Fault);
        second.Files.Save(overwrite: true);
        Assert.Equal("{// æ\r\n\r\n}\r\n", await File.ReadAllTextAsync(path));
    }

    [Fact]
    public void A_text_is_kept_while_it_is_typed_without_a_pause()
    {
        using SessionFolder folder = new();
        FakeTime time = new();
        using DocumentSession session = new(folder.User, ShippedScenes.Folder, time);
        for (int i = 0; i < 5; i++)
        {
            session.Document.TryReplace(session.Document.Revision, 0, 0, "/", "typing");
            time.Pass(TimeSpan.FromSeconds(0.3));
        }

        Assert.Contains("\"Text\":\"////", File.ReadAllText(Assert.Single(Directory.GetFiles(folder.User.Recovery, "*.json"))), StringComparison.Ordinal);
    }

    [Fact]
    public void A_recovered_text_survives_a_second_crash()
    {
        using SessionFolder folder = new();
        FakeTime time = new();
        using DocumentSession first = new(folder.User, ShippedScenes.Folder, time);
        first.Document.TryReplace(1, 0, 0, "// once\n", null);
        time.Ring();
        using SessionFolder crashed = AfterCrash(folder);
        using DocumentSession second = new(crashed.User, ShippedScenes.Folder, time);
        second.Files.OpenRecovered(second.Recovery.Entries[0].Id);
        using SessionFolder again = AfterCrash(crashed);
        using DocumentSession third = new(again.User, ShippedScenes.Folder, time);
        third.Files.OpenRecovered(Assert.Single(third.Recovery.Entries).Id);
        Assert.StartsWith("// once\n", third.Document.Text, StringComparison.Ordinal);
    }

    [Fact]
    public void Two_living_sessions_do_not_see_each_others_texts()
    {
        using SessionFolder folder = new();
        FakeTime time = new();
        using DocumentSession first = new(folder.User, ShippedScenes.Folder, time);
        first.Document.TryReplace(1, 0, 0, "// first\n", null);
        time.Ring();
        using DocumentSession second = new(folder.User, ShippedScenes.Folder, time);
        Assert.Empty(second.Recovery.Entries);
        second.Document.TryReplace(1, 0, 0, "// second\n", null);
        time.Ring();
        string[] kept = Directory.GetFiles(folder.User.Recovery, "*.json");
        Assert.Equal(2, kept.Length);
        string foreign = Path.GetFileNameWithoutExtension(kept.Single(k => File.ReadAllText(k).Contains("// first", StringComparison.Ordinal)));
        Assert.Throws<SessionException>(() => second.Files.OpenRecovered(foreign, discard: true));
        Assert.Throws<SessionException>(() => second.Recovery.Discard(foreign));
        Assert.Equal(2, Directory.GetFiles(folder.User.Recovery, "*.json").Length);
        second.Recovery.Refresh();
        Assert.Empty(second.Recovery.Entries);
    }

    [Fact]
    public void What_is_saved_or_undone_is_not_kept()
    {
        using SessionFolder folder = new();
        FakeTime time = new();
        using (DocumentSession session = new(folder.User, ShippedScenes.Folder, time))
        {
            session.Document.TryReplace(1, 0, 0, "// x\n", null);
            time.Ring();
            Assert.Single(Directory.GetFiles(folder.User.Recovery, "*.json"));
            session.Files.Save(folder["saved.json"]);
            Assert.Empty(Directory.GetFiles(folder.User.Recovery, "*.json"));
            session.Document.TryReplace(session.Document.Revision, 0, 0, "// y\n", null);
            time.Ring();
            Assert.Single(Directory.GetFiles(folder.User.Recovery, "*.json"));
            session.Document.Undo();
            Assert.Empty(Directory.GetFiles(folder.User.Recovery, "*.json"));
        }

        Assert.Empty(Directory.GetFiles(folder.User.Recovery));
    }

    [Fact]
    public void A_session_that_ends_with_changes_leaves_them_to_the_next_one()
    {
        using SessionFolder folder = new();
        FakeTime time = new();
        using (DocumentSession session = new(folder.User, ShippedScenes.Folder, time))
        {
            session.Document.TryReplace(1, 0, 0, "// x\n", null);
        }

        using DocumentSession next = new(folder.User, ShippedScenes.Folder, time);
        string id = Assert.Single(next.Recovery.Entries).Id;
        next.Recovery.Discard(id);
        Assert.Empty(next.Recovery.Entries);
        Assert.Throws<SessionException>(() => next.Recovery.Discard(id));
    }

    [Theory]
    [InlineData("../../secret")]
    [InlineData("")]
    [InlineData("0123456789abcdef0123456789abcdef")]
    public void Ids_that_are_none_are_refused(string id)
    {
        using SessionFolder folder = new();
        using DocumentSession session = new(folder.User, ShippedScenes.Folder, new FakeTime());
        Assert.Throws<SessionException>(() => session.Recovery.Discard(id));
        Assert.Throws<SessionException>(() => session.Files.OpenRecovered(id));
    }

    [Fact]
    public void Damaged_kept_texts_are_left_alone()
    {
        using SessionFolder folder = new();
        File.WriteAllText(Path.Combine(folder.User.Recovery, "0123456789abcdef0123456789abcdef.json"), "{ \"Name\": ");
        File.WriteAllText(Path.Combine(folder.User.Recovery, "0123456789abcdef0123456789abcdee.json"), "null");
        using DocumentSession session = new(folder.User, ShippedScenes.Folder, new FakeTime());
        Assert.Empty(session.Recovery.Entries);
    }

    // The files as they are when the power goes, and nobody holds them.
    private static SessionFolder AfterCrash(SessionFolder living)
    {
        SessionFolder crashed = new();
        foreach (string file in Directory.GetFiles(living.User.Recovery, "*.json"))
        {
            File.Copy(file, Path.Combine(crashed.User.Recovery, Path.GetFileName(file)));
        }

        return crashed;
    }
}
