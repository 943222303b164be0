using System.CommandLine;
using System.CommandLine.Parsing;
using RayTracer.Description;
using RayTracer.Sampling;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>The options that replace what a scene file says about rendering.</summary>
internal sealed class SceneOverrides
{
    private readonly ParsedOption<long?> _width = OptionValues.Parameter("--width", nameof(RenderDescription.Width));
    private readonly ParsedOption<long?> _height = OptionValues.Parameter("--height", nameof(RenderDescription.Height));
    private readonly ParsedOption<long?> _samples = OptionValues.Parameter("--spp", nameof(RenderDescription.SamplesPerPixel));
    private readonly ParsedOption<long?> _seed = OptionValues.Parameter("--seed", nameof(RenderDescription.Seed));
    private readonly ParsedOption<long?> _diffuseDepth = OptionValues.Parameter("--max-diffuse-depth", nameof(RenderDescription.MaxDiffuseDepth));
    private readonly ParsedOption<long?> _specularDepth = OptionValues.Parameter("--max-specular-depth", nameof(RenderDescription.MaxSpecularDepth));
    private readonly ParsedOption<long?> _maxDepth = OptionValues.Parameter("--max-depth", nameof(RenderDescription.MaxDepth));
    private readonly ParsedOption<Integrator?> _integrator = OptionValues.Choice(Integrator.Known, "--integrator", "How the light is computed. Overrides the scene's.");
    private readonly ParsedOption<SamplerKind?> _sampler = OptionValues.Choice(SamplerKind.Known, "--sampler", "How the samples of a pixel are placed. Overrides the scene's.");
    private readonly SettingOption _settings;
    private readonly Option[] _all;

    /// <summary>Gives a command the options.</summary>
    public SceneOverrides(Command command)
    {
        _all = [_width.Symbol, _height.Symbol, _samples.Symbol, _seed.Symbol, _sampler.Symbol, _integrator.Symbol, _maxDepth.Symbol, _diffuseDepth.Symbol, _specularDepth.Symbol];
        Array.ForEach(_all, command.Options.Add);
        _settings = new(command);
    }

    /// <summary>The options that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) => _all
        .Where(o => result.GetResult(o) is { Implicit: false })
        .SelectMany(o => new[] { o.Name, result.GetResult(o)!.Tokens[^1].Value })
        .Concat(_settings.Words(result));

    /// <summary>The values to put in the place of the file's before it is read.</summary>
    public IReadOnlyList<SceneSetting> Settings(ParseResult result) => _settings.Values(result);

    /// <summary>Whether the number of samples was given.</summary>
    public bool HasSamples(ParseResult result) => _samples.Value(result) is not null;

    /// <summary>A scene with the options put in.</summary>
    /// <exception cref="CommandException">The sampler cannot have that many samples.</exception>
    public SceneDescription Apply(ParseResult result, SceneDescription scene)
    {
        RenderDescription old = scene.Render;
        RenderDescription render = old with
        {
            Width = (int)(_width.Value(result) ?? old.Width),
            Height = (int)(_height.Value(result) ?? old.Height),
            SamplesPerPixel = (int)(_samples.Value(result) ?? old.SamplesPerPixel),
            Seed = _seed.Value(result) ?? old.Seed,
            MaxDiffuseDepth = (int)(_diffuseDepth.Value(result) ?? old.MaxDiffuseDepth),
            MaxSpecularDepth = (int)(_specularDepth.Value(result) ?? old.MaxSpecularDepth),
            MaxDepth = (int)(_maxDepth.Value(result) ?? old.MaxDepth),
            Integrator = _integrator.Value(result) ?? old.Integrator,
            Sampler = _sampler.Value(result) ?? old.Sampler,
        };
        Option? changed = new Option[] { _samples.Symbol, _sampler.Symbol }.FirstOrDefault(o => result.GetResult(o) is { Implicit: false });
        return changed is not null && render.Sampler.Complaint(render.SamplesPerPixel) is { } complaint
            ? throw new CommandException(ExitStatus.Usage, $"{changed.Name} {result.GetResult(changed)!.Tokens[^1].Value}: {complaint}")
            : scene with { Render = render };
    }
}
