using System.Text;
using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

/// <summary>Whatever stands in a file: reading never throws, and what is good is built.</summary>
public class SceneFuzzTests
{
    private static readonly string[] Pieces =
    [
        "{", "}", "[", "]", ",", ":", "\"", "\\", "/*", "//", "null", "true", "1e400", "-1", "0", "\"type\"", "\"red\"", "\"sphere\"", "\"tiles\"",
        "\"mirror\"", "\"polished\"", "\n", "\uD800", "😀", "\0", "[0,0,0]", "{\"type\":\"checker\"}", "\"material\":", "\"center\":", "1e-60", "3e38",
    ];

    [Fact]
    public void Every_beginning_of_a_scene_is_an_error_without_an_exception()
    {
        string text = SceneReference.Example;
        int end = text.TrimEnd().Length;
        for (int length = 0; length < end; length++)
        {
            SceneReadResult result = SceneReader.ReadText(text[..length], "cut.json");
            Assert.Null(result.Description);
            Assert.Single(result.Diagnostics);
        }
    }

    [Fact]
    public void Scenes_with_random_pieces_replaced_never_throw()
    {
        Random random = new(2009);
        int good = 0;
        for (int i = 0; i < 3000; i++)
        {
            StringBuilder text = new(SceneReference.Example);
            for (int edit = random.Next(1, 4); edit > 0; edit--)
            {
                int at = random.Next(text.Length);
                text.Remove(at, Math.Min(random.Next(6), text.Length - at)).Insert(at, Pieces[random.Next(Pieces.Length)]);
            }

            SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(text.ToString(), "mutated.json"), "");
            Assert.Equal(result.Scene is null, result.Diagnostics.Any(d => d.Severity == Severity.Error));
            good += result.Scene is null ? 0 : 1;
        }

        Assert.InRange(good, 1, 2999);
    }

    [Fact]
    public void Random_bytes_never_throw()
    {
        Random random = new(2010);
        byte[] good = Encoding.UTF8.GetBytes(SceneReference.Example);
        for (int i = 0; i < 1000; i++)
        {
            byte[] bytes = [.. good];
            for (int edit = 0; edit < 3; edit++)
            {
                bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            }

            SourceText source = SourceText.Decode("bytes.json", bytes, out Diagnostic? error);
            Assert.True(error is not null || SceneReader.ReadText(source.Text, "bytes.json") is not null);
        }
    }

    [Fact]
    public void Many_unknown_names_end_quickly()
    {
        string names = string.Join(", ", Enumerable.Range(0, 5000).Select(i => $"\"texture number {i}\": \"nothing like {i}\""));
        SceneReadResult result = SceneReader.ReadText($"{{ \"textures\": {{ {names} }} }}", "many.json");
        Assert.Equal(5000, result.Diagnostics.Count);
    }
}
