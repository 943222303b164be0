using System.CommandLine;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>The option <c>--set PATH=VALUE</c>, which may be given several times, of verbs that read a scene.</summary>
internal sealed class SettingOption
{
    /// <summary>The option's name.</summary>
    public const string Name = "--set";

    private readonly Option<string[]> _option = new(Name)
    {
        HelpName = "PATH=VALUE",
        Description = "Overrides a value of the scene, with the same checks: --set camera.fieldOfView=35, --set shapes[2].radius=1, --set materials.glass.color=red. Repeatable.",
    };

    /// <summary>Gives a command the option.</summary>
    public SettingOption(Command command)
    {
        _option.Validators.Add(result =>
        {
            foreach (string text in result.Tokens.Select(t => t.Value))
            {
                try
                {
                    SceneSetting.Parse(text);
                }
                catch (FormatException e)
                {
                    result.AddError($"{Name} {text}: {e.Message}");
                }
            }
        });
        command.Options.Add(_option);
    }

    /// <summary>The settings that were given.</summary>
    public IReadOnlyList<SceneSetting> Values(ParseResult result) => [.. Texts(result).Select(SceneSetting.Parse)];

    /// <summary>The options that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) => Texts(result).SelectMany(t => new[] { Name, t });

    private string[] Texts(ParseResult result) => result.GetValue(_option) ?? [];
}
