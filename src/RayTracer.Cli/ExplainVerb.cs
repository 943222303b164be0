using System.CommandLine;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary><c>raytracer explain [TOPIC…]</c></summary>
internal static class ExplainVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> topics = new("TOPIC") { Description = "Keys and types of scene files, joined by dots: camera.fieldOfView, sphere, materials.glass; without any, all are listed.", Arity = ArgumentArity.ZeroOrMore };
        command.Arguments.Add(topics);
        command.SetAction(result => streams.Output.Write(
            result.GetValue(topics) is { Length: > 0 } words ? string.Join("\n", words.Select(Text)) : SceneExplanation.Topics()));
    }

    private static string Text(string topic)
    {
        try
        {
            return SceneExplanation.Of(topic);
        }
        catch (FormatException e)
        {
            throw new CommandException(ExitStatus.Usage, $"{e.Message} (\"raytracer explain\" lists all)");
        }
    }
}
