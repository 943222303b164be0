using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The scenes that come with the program.</summary>
internal sealed class GalleryViewModel(SessionDispatcher dispatcher, Action<string> open)
{
    private CancellationTokenSource? _loading;

    /// <summary>The scenes in groups.</summary>
    public IReadOnlyList<GalleryGroupViewModel> Groups { get; private set; } = [];

    /// <summary>Lists the scenes.</summary>
    public void Show(IReadOnlyList<GalleryGroup> groups) =>
        Groups = [.. groups.Select(g => new GalleryGroupViewModel(g.Title, [.. g.Items.Select(i => new GalleryItemViewModel(i, () => open(i.Id)))]))];

    /// <summary>Makes the pictures, one after another.</summary>
    public async Task LoadPictures(CancellationToken stop)
    {
        _loading?.Cancel();
        _loading = CancellationTokenSource.CreateLinkedTokenSource(stop);
        foreach (GalleryItemViewModel item in Groups.SelectMany(g => g.Items).Where(i => i.Picture is null))
        {
            CancellationToken token = _loading.Token;
            if (!await dispatcher.Attempt(async () => item.Picture = await dispatcher.Aside(s => s.Gallery.Thumbnail(item.Id, token))) && token.IsCancellationRequested)
            {
                return;
            }
        }
    }
}

/// <summary>Shipped scenes that belong together.</summary>
/// <param name="Title">The title of the group.</param>
/// <param name="Items">The scenes.</param>
internal sealed record GalleryGroupViewModel(string Title, IReadOnlyList<GalleryItemViewModel> Items);

/// <summary>A shipped scene.</summary>
internal sealed class GalleryItemViewModel(GalleryItem item, Action open) : Observable
{
    public string Id => item.Id;

    public string Name => item.Name;

    /// <summary>The description.</summary>
    public string Summary => item.Summary;

    /// <summary>The text for screen readers.</summary>
    public string Label => SessionTexts.Of("gallery.open", item.Name);

    /// <summary>Its small picture as a PNG file; null until it is made.</summary>
    public byte[]? Picture { get; set => SetProperty(ref field, value); }

    /// <summary>Opens it.</summary>
    public ICommand Open { get; } = new RelayCommand(open);
}
