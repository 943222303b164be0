using System.Windows.Input;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Asks how to write the picture.</summary>
internal sealed class ExportViewModel : DialogViewModel
{
    private Choice _format;
    private Choice _bits;

    /// <summary>The question.</summary>
    /// <param name="write">Takes the format's extension, without its dot, and what to write; asks where to.</param>
    public ExportViewModel(Action<string, PictureRequest> write)
    {
        (_format, _bits) = (Formats[0], Bits[0]);
        Write = Button(() => write(_format.Value, PictureRequest.Of(
            int.Parse(_bits.Value, System.Globalization.CultureInfo.InvariantCulture),
            HasLayers ? Layers.Where(l => l.IsOn).Select(l => l.Name) : [])));
    }

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("dialogs.exportTitle");

    /// <summary>The formats.</summary>
    public IReadOnlyList<Choice> Formats { get; } = [.. PictureSaver.Formats.Select(f => new Choice(f.Value, f.Label))];

    /// <summary>The format.</summary>
    public Choice? Format
    {
        get => _format;
        set
        {
            if (value is not null && Set(ref _format, value))
            {
                Tell(nameof(HasDepth));
                Tell(nameof(HasLayers));
            }
        }
    }

    /// <summary>Bits a channel.</summary>
    public IReadOnlyList<Choice> Bits { get; } = [new("8", "8"), new("16", "16")];

    /// <summary>Bits a channel.</summary>
    public Choice? BitDepth
    {
        get => _bits;
        set => Set(ref _bits, value ?? _bits);
    }

    /// <summary>The layers.</summary>
    public IReadOnlyList<LayerChoice> Layers { get; } =
        [.. AuxiliaryImage.Known.All.Select(i => new LayerChoice(i.Name, i.Title))];

    /// <summary>Whether bits a channel can be chosen.</summary>
    public bool HasDepth => Chosen.HasDepth;

    /// <summary>Whether it takes auxiliary images.</summary>
    public bool HasLayers => Chosen.HasLayers;

    /// <summary>Writes it.</summary>
    public ICommand Write { get; }

    private PictureFormat Chosen => PictureSaver.Formats.First(f => f.Value == _format.Value);
}

/// <summary>A layer that an OpenEXR file may have.</summary>
/// <param name="Name">How files call it.</param>
/// <param name="Label">What it is called.</param>
internal sealed record LayerChoice(string Name, string Label)
{
    /// <summary>Whether it is wanted.</summary>
    public bool IsOn { get; set; }
}
