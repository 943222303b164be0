using RayTracer.Imaging;

namespace RayTracer.Tests.Imaging;

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
        Assert.Equal($"Cannot write '{_folder["a"]}': No space left on device : 'a temporary file beside it'.", error.Message);
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
    public void A_place_that_cannot_be_written_is_refused_beforehand_and_in_the_end(string name, string message)
    {
        File.WriteAllText(_folder["file"], "");
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => AtomicFile.Check(_folder[name])).Message);
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => AtomicFile.Write(_folder[name], _ => { })).Message);
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    [InlineData("a\0b")]
    public void A_name_that_cannot_be_one_is_refused(string name) =>
        Assert.Contains("not the name of a file", Assert.Throws<ImageWriteException>(() => AtomicFile.Write(name, _ => { })).Message);

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
