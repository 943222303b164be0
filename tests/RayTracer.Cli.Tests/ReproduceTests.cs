namespace RayTracer.Cli.Tests;

public sealed class ReproduceTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void File_in_place_of_the_folder_is_an_error()
    {
        string file = _folder["file"];
        File.WriteAllText(file, "x");
        CliRun run = CliRun.Of("reproduce", "report", "--quick", "-o", file);
        Assert.Equal((4, ""), (run.Status, run.Output));
        Assert.Contains("is a file, but a folder is expected", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
        run = CliRun.Of("reproduce", "report", "--quick", "-o", Path.Combine(file, "below"));
        Assert.Equal(4, run.Status);
        Assert.Contains("cannot be made", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
        Assert.Equal("x", File.ReadAllText(file));
    }

    [Fact]
    public void Folder_in_place_of_a_file_is_an_error_before_the_work()
    {
        Directory.CreateDirectory(_folder["index.md"]);
        CliRun run = CliRun.Of("reproduce", "report", "--quick", "-o", _folder.Path);
        Assert.Equal((4, ""), (run.Status, run.Output));
        Assert.Single(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Wrong_usage_is_reported()
    {
        Assert.Equal(2, CliRun.Of("reproduce").Status);
        Assert.Contains("-o FOLDER", CliRun.Of("reproduce", "report").Error, StringComparison.Ordinal);
        CliRun run = CliRun.Of("reproduce", "reprot", "-o", _folder.Path);
        Assert.Equal(2, run.Status);
        Assert.Contains("did you mean \"report\"?", run.Error, StringComparison.Ordinal);
    }
}
