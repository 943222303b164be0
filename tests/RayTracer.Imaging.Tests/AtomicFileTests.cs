using System.Runtime.Versioning;
using RayTracer.Imaging;

namespace RayTracer.Imaging.Tests;

public sealed class AtomicFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Write_replaces_a_file()
    {
        File.WriteAllText(_folder["a"], "old");
        AtomicFile.Write(_folder["a"], stream => stream.Write("new"u8));
        Assert.Equal("new", File.ReadAllText(_folder["a"]));
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void A_full_disk_leaves_the_old_file_and_nothing_else()
    {
        File.WriteAllText(_folder["a"], "old");
        var error = Assert.Throws<ImageWriteException>(() => AtomicFile.Write(_folder["a"], stream =>
        {
            stream.Write("half"u8);
            throw new IOException($"No space left on device : '{((FileStream)stream).Name}'");
        }));
        Assert.Equal("old", File.ReadAllText(_folder["a"]));
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
        Assert.Equal($"Cannot write '{_folder["a"]}': No space left on device.", error.Message);
    }

    [Fact]
    public void Many_writers_of_one_file_leave_one_of_their_contents_whole()
    {
        Parallel.For(0, 32, i => AtomicFile.Write(_folder["a"], stream => stream.Write(Enumerable.Repeat((byte)i, 10_000).ToArray())));
        byte[] content = File.ReadAllBytes(_folder["a"]);
        Assert.Equal(10_000, content.Length);
        Assert.Single(content.Distinct());
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [LinuxFact]
    public void What_killed_writers_of_a_file_have_left_is_deleted_and_nothing_else()
    {
        string[] left = [.. Enumerable.Range(0, 4).Select(_ => AtomicFile.Temporary(_folder["a"]))];
        string other = AtomicFile.Temporary(_folder["b"]);
        DateTime now = DateTime.UtcNow;
        foreach (string path in left.Append(other))
        {
            File.WriteAllText(path, "half");
            File.SetLastWriteTimeUtc(path, now.AddMinutes(-2));
        }

        // One was written to lately, and one is open, as while a slow disk is waited for.
        File.SetLastWriteTimeUtc(left[2], now);
        using (new FileStream(left[3], FileMode.Open, FileAccess.ReadWrite, FileShare.Delete))
        {
            AtomicFile.Sweep(_folder["a"], now.AddMinutes(-1));
            Assert.Equal(new[] { left[2], left[3], other }.Order(), Directory.GetFileSystemEntries(_folder.Path).Order());
        }

        AtomicFile.Sweep(_folder["a"], now.AddMinutes(-1));
        Assert.Equal(new[] { left[2], other }.Order(), Directory.GetFileSystemEntries(_folder.Path).Order());
    }

    [LinuxFact]
    [UnsupportedOSPlatform("windows")]
    public void A_file_that_only_its_owner_may_read_stays_so()
    {
        const UnixFileMode Own = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        File.WriteAllText(_folder["a"], "old");
        File.SetUnixFileMode(_folder["a"], Own);
        AtomicFile.Write(_folder["a"], stream =>
        {
            Assert.Equal(Own, File.GetUnixFileMode(((FileStream)stream).SafeFileHandle));
            stream.Write("new"u8);
        });
        Assert.Equal(Own, File.GetUnixFileMode(_folder["a"]));
    }

    [Fact]
    public void Long_names_have_temporary_ones_that_are_no_longer_than_names_may_be()
    {
        string name = new string('ö', 120) + ".png";
        AtomicFile.Write(_folder[name], stream => stream.Write("new"u8));
        Assert.Equal([_folder[name]], Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Other_exceptions_pass_through_and_nothing_is_left()
    {
        Assert.Throws<OperationCanceledException>(() => AtomicFile.Write(_folder["a"], _ => throw new OperationCanceledException()));
        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [InlineData("missing/a", "does not exist")]
    [InlineData("", "that is a folder")]
    [InlineData("file/a", "does not exist")]
    [InlineData("LONG", "its name is too long: it has 256 bytes, and file names have at most 255")]
    public void A_place_that_cannot_be_written_is_refused_beforehand_and_in_the_end(string name, string message)
    {
        File.WriteAllText(_folder["file"], "");
        name = name == "LONG" ? new('a', 256) : name;
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => AtomicFile.Check(_folder[name])).Message);
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => AtomicFile.Write(_folder[name], _ => { })).Message);
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    [InlineData("a\0b")]
    public void A_name_that_cannot_be_one_is_refused(string name) =>
        Assert.Contains("not a file name", Assert.Throws<ImageWriteException>(() => AtomicFile.Write(name, _ => { })).Message);

    [Fact]
    public void A_symbolic_link_stays_one_and_its_file_is_replaced()
    {
        File.WriteAllText(_folder["target"], "old");
        File.CreateSymbolicLink(_folder["link"], "target");
        AtomicFile.Write(_folder["link"], stream => stream.Write("new"u8));
        Assert.Equal("target", new FileInfo(_folder["link"]).LinkTarget);
        Assert.Equal("new", File.ReadAllText(_folder["target"]));
    }

    [LinuxFact]
    public void A_folder_that_is_not_writable_is_refused()
    {
        Assert.StartsWith("Cannot write '/proc/a': ", Assert.Throws<ImageWriteException>(() => AtomicFile.Write("/proc/a", _ => { })).Message);
    }
}
