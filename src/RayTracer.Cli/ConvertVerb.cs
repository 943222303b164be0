using System.CommandLine;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Cli;

/// <summary><c>raytracer convert SCENE FILE</c>: writes a scene, of Mitsuba or a model, in the native format.</summary>
internal static class ConvertVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string> scene = new("SCENE") { Description = "The scene file to read: of Mitsuba (.xml), native (.json), or a model." };
        Argument<string> file = new("FILE") { Description = "The native scene file to write, .json." };
        command.Arguments.Add(scene);
        command.Arguments.Add(file);
        command.SetAction(result => Convert(result.GetValue(scene)!, result.GetValue(file)!, streams));
    }

    private static int Convert(string path, string target, Streams streams)
    {
        if (!Path.GetExtension(target).Equals(".json", StringComparison.OrdinalIgnoreCase))
        {
            throw new CommandException(ExitStatus.Usage, $"scenes are written as .json files, but not as {Quotation.Of(target)}");
        }

        SceneLoadResult result = SceneFile.Load(path);
        SceneFile.Show(result, streams);
        if (result.Scene is null)
        {
            return SceneFile.FailureStatus(path);
        }

        // The names of files in the scene are meant from where it was.
        string text = FileNames.Move(SceneWriter.Write(result.Description!), Folder(path), Folder(target));
        AtomicFile.Write(target, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        return ExitStatus.Fine;
    }

    private static string Folder(string path) => Path.GetDirectoryName(Path.GetFullPath(path)) ?? "";
}
