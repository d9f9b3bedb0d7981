-- | The animation that a scene file and options make together.
module BlackHole.Cli.AnimationScene
  ( loadAnimation,
    resolveAnimation,
    frameFaults,
    maximumFaults,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.AnimationFile
import BlackHole.Animation.Progress (frameRanges)
import BlackHole.Cli.SceneOptions
import BlackHole.Image.SceneSource (readSceneFile)
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene (Scene)
import qualified Data.ByteString as Bytes
import Data.Either (fromRight)
import Data.Foldable (fold)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map

-- | The animation that the options ask for, given the bytes of the scene file, or one line for
-- each mistake in its scene and its section @animation@. 'Nothing' if there is no such
-- section. Does not validate the scenes of the frames; see 'frameFaults'.
resolveAnimation :: SceneOptions -> Maybe Bytes.ByteString -> Either [String] (Maybe Animation)
resolveAnimation options bytes = case (resolveScene options bytes, section) of
  (Left problems, _) -> Left (problems ++ sectionFaults)
  (_, Just (_, _ : _)) -> Left sectionFaults
  (Right scene, Just (animation, [])) -> Right (Just (animation scene))
  (Right _, Nothing) -> Right Nothing
  where
    -- A file that is not YAML is reported with the scene.
    section = bytes >>= fromRight Nothing . parseYaml >>= readAnimation
    sectionFaults =
      [ concat [fold (sceneFile options), ":", show line, ": ", renderProblem problem]
        | (line, problem) <- sortOn fst (maybe [] snd section)
      ]

-- | The animation that the options ask for, like 'resolveAnimation', or without a section
-- @animation@ its single scene. Reads the file, and warns of former names on standard
-- error.
loadAnimation :: SceneOptions -> IO (Either [String] (Either Scene Animation))
loadAnimation options = do
  bytes <- traverse readSceneFile (sceneFile options)
  mapM_ (mapM_ (warnFormerNames options)) bytes
  pure $ case sequence bytes of
    Left line -> Left [line]
    Right contents -> do
      animation <- resolveAnimation options contents
      maybe (Left <$> resolveScene options contents) (Right . Right) animation

-- | One line for each mistake in the scenes of some frames (in increasing order), with
-- the numbers of all frames that have it.
frameFaults :: Animation -> [Int] -> [String]
frameFaults animation frames =
  [ (if length wrong == 1 then "frame " else "frames ") ++ frameRanges (reverse wrong)
      ++ ": "
      ++ text
    | (text, wrong) <- sortOn (lastOf . snd) (Map.toList faults)
  ]
  where
    faults =
      Map.fromListWith
        (++)
        [ (renderProblem problem, [n])
          | n <- frames,
            Left problems <- [frameScenes animation n],
            problem <- problems
        ]
    lastOf = foldl (const Just) Nothing

-- | The greatest number of such lines to print.
maximumFaults :: Int
maximumFaults = 20
