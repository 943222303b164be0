namespace RayTracer.Jobs.Tests;

/// <summary>The scene of a picture is found again.</summary>
public sealed class JobOriginTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("k.json", "k.png", "k.png", "k.json")]
    [InlineData("scenes/k.json", "out/k.png", "out/k.png", "scenes/k.json")]
    [InlineData("scenes/k.json", "out/k.png", "./out/k.png", "scenes/k.json")]
    [InlineData("elsewhere/k.json", "k.png", "k.png", "k.json")]
    [InlineData("scenes/k.json", "out/moved.png", "out/k.png", "out/k.json")]
    public void It_is_looked_for_from_the_folder_where_the_command_ran(string scene, string file, string output, string expected)
    {
        Directory.CreateDirectory(_folder["scenes"]);
        Directory.CreateDirectory(_folder["out"]);
        foreach (string name in new[] { "k.json", "scenes/k.json", "out/k.json" })
        {
            File.WriteAllText(_folder[name], "");
        }

        Assert.Equal(_folder[expected], JobOrigin.ScenePath(scene, _folder[file], [output]));
    }

    [Fact]
    public void One_of_the_same_name_in_the_current_folder_is_not_taken_for_it()
    {
        string here = Path.GetFileName(Directory.GetFiles(".")[0]);
        Assert.Equal(here, JobOrigin.ScenePath(here, _folder["k.png"], ["k.png"]));
        File.WriteAllText(_folder[here], "");
        Assert.Equal(_folder[here], JobOrigin.ScenePath(here, _folder["k.png"], ["k.png"]));
    }
}
