using System.CommandLine;
using System.CommandLine.Parsing;
using RayTracer.Description;
using RayTracer.Sampling;

namespace RayTracer.Cli;

/// <summary>The options that replace what a scene file says about rendering.</summary>
internal sealed class SceneOverrides
{
    private readonly Option<long?> _width = OptionValues.Parameter("--width", nameof(RenderDescription.Width));
    private readonly Option<long?> _height = OptionValues.Parameter("--height", nameof(RenderDescription.Height));
    private readonly Option<long?> _samples = OptionValues.Parameter("--spp", nameof(RenderDescription.SamplesPerPixel));
    private readonly Option<long?> _seed = OptionValues.Parameter("--seed", nameof(RenderDescription.Seed));
    private readonly Option<long?> _diffuseDepth = OptionValues.Parameter("--max-diffuse-depth", nameof(RenderDescription.MaxDiffuseDepth));
    private readonly Option<long?> _specularDepth = OptionValues.Parameter("--max-specular-depth", nameof(RenderDescription.MaxSpecularDepth));
    private readonly Option<SamplerKind?> _sampler = OptionValues.Choice<SamplerKind>("--sampler", "How the samples of a pixel are placed. Replaces the scene's.");
    private readonly Option[] _all;

    /// <summary>Gives a command the options.</summary>
    public SceneOverrides(Command command)
    {
        _all = [_width, _height, _samples, _seed, _sampler, _diffuseDepth, _specularDepth];
        Array.ForEach(_all, command.Options.Add);
    }

    /// <summary>The options that were given, as words of a command line.</summary>
    public IEnumerable<string> Words(ParseResult result) => _all
        .Where(o => result.GetResult(o) is { Implicit: false })
        .SelectMany(o => new[] { o.Name, result.GetResult(o)!.Tokens[^1].Value });

    /// <summary>A scene with the options put in.</summary>
    /// <exception cref="CommandException">The sampler cannot have that many samples.</exception>
    public SceneDescription Apply(ParseResult result, SceneDescription scene)
    {
        RenderDescription old = scene.Render;
        RenderDescription render = old with
        {
            Width = (int)(result.GetValue(_width) ?? old.Width),
            Height = (int)(result.GetValue(_height) ?? old.Height),
            SamplesPerPixel = (int)(result.GetValue(_samples) ?? old.SamplesPerPixel),
            Seed = result.GetValue(_seed) ?? old.Seed,
            MaxDiffuseDepth = (int)(result.GetValue(_diffuseDepth) ?? old.MaxDiffuseDepth),
            MaxSpecularDepth = (int)(result.GetValue(_specularDepth) ?? old.MaxSpecularDepth),
            Sampler = result.GetValue(_sampler) ?? old.Sampler,
        };
        Option? changed = new Option[] { _samples, _sampler }.FirstOrDefault(o => result.GetResult(o) is { Implicit: false });
        return changed is not null && Sampler.Complaint(render.Sampler, render.SamplesPerPixel) is { } complaint
            ? throw new CommandException(ExitStatus.Usage, $"{changed.Name} {result.GetResult(changed)!.Tokens[^1].Value}: {complaint}")
            : scene with { Render = render };
    }
}
