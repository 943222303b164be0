using System.Windows.Input;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Asks how to write the picture.</summary>
/// <param name="write">Takes the format's extension, without its dot, the bits a channel and the layers; asks where to.</param>
internal sealed class ExportViewModel(Action<string, int, IEnumerable<string>> write) : DialogViewModel
{
    private static readonly Choice[] AllFormats = [.. PictureSaver.Formats.Select(f => new Choice(f.Value, f.Label))];
    private static readonly Choice[] AllBits = [new("8", "8"), new("16", "16")];
    private Choice _format = AllFormats[0];
    private Choice _bits = AllBits[0];

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.exportTitle");

    /// <summary>The formats.</summary>
    public IReadOnlyList<Choice> Formats => AllFormats;

    /// <summary>The format.</summary>
    public Choice? Format
    {
        get => _format;
        set
        {
            if (value is not null && SetProperty(ref _format, value))
            {
                Report(nameof(HasDepth), nameof(HasLayers));
            }
        }
    }

    /// <summary>Bits a channel.</summary>
    public IReadOnlyList<Choice> Bits => AllBits;

    /// <summary>Bits a channel.</summary>
    public Choice? BitDepth
    {
        get => _bits;
        set => SetProperty(ref _bits, value ?? _bits);
    }

    /// <summary>The layers.</summary>
    public IReadOnlyList<LayerChoice> Layers { get; } =
        [.. AuxiliaryImage.Known.All.Select(i => new LayerChoice(i.Name, i.Title))];

    public bool HasDepth => Chosen.HasDepth;

    /// <summary>Returns whether the format takes auxiliary images.</summary>
    public bool HasLayers => Chosen.HasLayers;

    /// <summary>Writes it.</summary>
    public ICommand Write => field ??= Button(() => write(
        _format.Value,
        int.Parse(_bits.Value, System.Globalization.CultureInfo.InvariantCulture),
        HasLayers ? Layers.Where(l => l.IsOn).Select(l => l.Name) : []));

    private PictureFormat Chosen => PictureSaver.Formats.First(f => f.Value == _format.Value);
}

/// <summary>A layer that an OpenEXR file may have.</summary>
/// <param name="Name">Its name in files.</param>
/// <param name="Label">Its name in the dialog.</param>
internal sealed record LayerChoice(string Name, string Label)
{
    public bool IsOn { get; set; }
}
