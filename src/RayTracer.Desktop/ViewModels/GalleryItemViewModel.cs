using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A shipped scene.</summary>
internal sealed class GalleryItemViewModel(GalleryItem item, Action open) : Observable
{
    private byte[]? _picture;

    /// <summary>How the session calls it.</summary>
    public string Id => item.Id;

    /// <summary>What it is called.</summary>
    public string Name => item.Name;

    /// <summary>What it shows.</summary>
    public string Summary => item.Summary;

    /// <summary>What a screen reader says.</summary>
    public string Label => SessionTexts.Of("gallery.open", item.Name);

    /// <summary>Its small picture as a PNG file; null until it is made.</summary>
    public byte[]? Picture
    {
        get => _picture;
        set => Set(ref _picture, value);
    }

    /// <summary>Opens it.</summary>
    public ICommand Open { get; } = new ActionCommand(open);
}
