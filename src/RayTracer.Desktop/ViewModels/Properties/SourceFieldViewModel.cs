using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Something long, which is better edited as text.</summary>
internal sealed class SourceFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>Whether something is written.</summary>
    public bool IsWritten => Written is not null;

    /// <summary>Shows it in the source.</summary>
    public ICommand ShowText => new ActionCommand(() => Context.ShowInSource(Pointer));

    /// <inheritdoc/>
    protected override void Shown()
    {
    }
}
