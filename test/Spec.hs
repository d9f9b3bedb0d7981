{-# OPTIONS_GHC -F -pgmF hspec-discover -optF --no-main -Wno-missing-export-lists #-}
